#pragma once

#include "core/compute/program.h"
#include "tests/support/test_scenes.h"

#include <fstream>
#include <sstream>

namespace prizma::test {

/// Light sampling by itself (light_probe.cl): what kernels/light_sampling.clh gives for any point and random
/// numbers. The scene's anchor is its camera's position.
class LightProbe {
  public:
    struct Question {
        float position[3];
        float normal[3]; ///< Unit, or 0.
        float u[3];
    };

    struct Answer {
        float direction[3];
        float distance;
        float radiance[3];
        float pdf;
        std::uint32_t isDelta;
        float otherPdf;    ///< Of whoever is met in that direction.
        std::uint32_t met; ///< 0 nothing, 1 a light, 2 a surface, 3 the background.
        float metRadiance[3];

        glm::dvec3 towards() const { return {direction[0], direction[1], direction[2]}; }
    };

    explicit LightProbe(Renderer& renderer) : renderer_(renderer) {
        std::ifstream file(PRIZMA_SOURCE_DIR "/tests/support/light_probe.cl");
        std::stringstream text;
        text << file.rdbuf();
        const char* layout = renderer.layout() == TreeLayout::Wide8 ? "-D PRIZMA_WIDE8" : "-D PRIZMA_BINARY2";
        const auto program = buildProgram(renderer.context(), "light_probe.cl", text.str(), layout);
        if (!program)
            qFatal("%s", program.error().message.c_str());
        sample_ = take(Kernel::create(*program, "sampleEvents"));
        densities_ = take(Kernel::create(*program, "densitiesAlong"));
        choose_ = take(Kernel::create(*program, "chooseEmitters"));
        chances_ = take(Kernel::create(*program, "chancesOfNodes"));
    }

    void setScene(const Scene& scene) {
        renderer_.waitForTrees(scene);
        const Scene drawn = renderer_.drawable(scene);
        check(renderer_.begin(renderer_.plan(drawn, 1, 1), drawn, 1, 1));
        renderer_.drop();
        const Background& background = scene.background;
        shading_ = {};
        for (int i = 0; i < 3; ++i)
            shading_.background[i] = static_cast<float>(
                (background.image.isSet() ? 1.0 : background.color[i]) * background.intensity);
        shading_.backgroundTexture = renderer_.deviceScene().materials().indexOf(background.image);
        shading_.backgroundTurn[0] = static_cast<float>(std::cos(glm::radians(background.rotation)));
        shading_.backgroundTurn[1] = static_cast<float>(std::sin(glm::radians(background.rotation)));
    }

    /// One event a question.
    std::vector<Answer> sample(const std::vector<Question>& questions) {
        std::vector<Answer> answers(questions.size());
        run(sample_, questions, answers);
        return answers;
    }

    /// Fills in what is met along each answer's direction, and with which density it is chosen.
    void densitiesAlong(const std::vector<Question>& questions, std::vector<Answer>& answers) {
        run(densities_, questions, answers);
    }

    /// An emitter of the light tree (PRIZMA_NO_HIT: none), and the probability of coming to it.
    struct Choice {
        std::uint32_t emitter;
        float probability;
    };

    /// Where a walk down the tree ends, for each question.
    std::vector<Choice> choose(const std::vector<Question>& questions) {
        return choices(choose_, questions, questions.size());
    }

    /// All leaves, as seen from `from`.
    std::vector<Choice> chances(const Question& from) {
        const std::size_t emitters = leafCount();
        std::vector<Choice> all = choices(chances_, {from}, emitters == 0 ? 0 : 2 * emitters - 1);
        std::erase_if(all, [](const Choice& choice) { return choice.probability < 0.0f; });
        return all;
    }

    /// Lights that are not directional, and triangles that shine.
    std::size_t leafCount() const {
        const LightStore& lights = renderer_.deviceScene().lights();
        return lights.treeSize() == 0 ? 0 : (lights.treeSize() + 1) / 2;
    }

    /// Of the last kernel.
    double lastMilliseconds() const { return milliseconds_; }

  private:
    static void check(const Result<void>& ok) {
        if (!ok)
            qFatal("%s", ok.error().message.c_str());
    }

    static Kernel take(Result<Kernel> kernel) {
        if (!kernel)
            qFatal("%s", kernel.error().message.c_str());
        return std::move(*kernel);
    }

    void run(Kernel& kernel, const std::vector<Question>& questions, std::vector<Answer>& answers) {
        Context& context = renderer_.context();
        check(questions_.assign(context, questions, "questions"));
        check(answers_.assign(context, answers, "answers"));
        renderer_.deviceScene().setSceneArguments(kernel);
        kernel.addArgument(shading_);
        kernel.addArgument(questions_);
        kernel.addArgument(answers_);
        kernel.addArgument(static_cast<std::uint32_t>(questions.size()));
        const auto launched = kernel.launch(context, questions.size(), 64);
        if (!launched)
            qFatal("%s", launched.error().message.c_str());
        check(answers_.read(context, answers, 0, "answers"));
        milliseconds_ = milliseconds(*launched);
    }

    std::vector<Choice> choices(Kernel& kernel, const std::vector<Question>& questions, std::size_t count) {
        Context& context = renderer_.context();
        std::vector<std::uint32_t> emitters(count);
        std::vector<float> probabilities(count);
        check(questions_.assign(context, questions, "questions"));
        check(emitters_.reserve(context, count, "emitters"));
        check(probabilities_.reserve(context, count, "probabilities"));
        renderer_.deviceScene().setSceneArguments(kernel);
        kernel.addArgument(questions_);
        kernel.addArgument(emitters_);
        kernel.addArgument(probabilities_);
        kernel.addArgument(static_cast<std::uint32_t>(count));
        if (const auto launched = kernel.launch(context, count, 64); !launched)
            qFatal("%s", launched.error().message.c_str());
        check(emitters_.read(context, emitters, 0, "emitters"));
        check(probabilities_.read(context, probabilities, 0, "probabilities"));
        std::vector<Choice> result;
        for (std::size_t i = 0; i < count; ++i)
            result.push_back({emitters[i], probabilities[i]});
        return result;
    }

    Renderer& renderer_;
    Kernel sample_, densities_, choose_, chances_;
    Buffer<std::uint32_t> emitters_;
    Buffer<float> probabilities_;
    Buffer<Question> questions_;
    Buffer<Answer> answers_;
    DeviceShading shading_{};
    double milliseconds_ = 0.0;
};

} // namespace prizma::test
