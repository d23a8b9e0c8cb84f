#include "core/bench/embree_refit.h"

#ifdef PRIZMA_WITH_EMBREE

#include "core/bench/embree_handles.h"
#include "core/bench/statistics_of.h"

#include <algorithm>

namespace prizma::bench {
namespace {

class Refit final : public EmbreeRefit {
  public:
    explicit Refit(const std::vector<MeshPtr>& meshes)
        : meshes_(meshes), device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_.get())) {
        // Embree 3 keeps a tree a geometry, which can be refitted, only in scenes of this kind.
        rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_DYNAMIC);
        rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_LOW);
        for (const MeshPtr& mesh : meshes_)
            corners_.push_back(padded(mesh->positions));
        for (std::size_t i = 0; i < meshes_.size(); ++i)
            geometries_.push_back(
                attach(device_.get(), scene_.get(), *meshes_[i], corners_[i], RTC_BUILD_QUALITY_REFIT));
        rtcCommitScene(scene_.get());
    }

    double refit(std::span<const std::vector<glm::vec3>> positions) override {
        for (std::size_t i = 0; i < corners_.size(); ++i)
            std::copy(positions[i].begin(), positions[i].end(), corners_[i].begin());
        return measure([&] {
            for (const auto& geometry : geometries_) {
                rtcUpdateGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_VERTEX, 0);
                rtcCommitGeometry(geometry.get());
            }
            rtcCommitScene(scene_.get());
        });
    }

  private:
    std::vector<MeshPtr> meshes_;
    std::vector<EmbreeCorners> corners_;
    EmbreeOwned<RTCDevice> device_;
    EmbreeOwned<RTCScene> scene_;
    std::vector<EmbreeOwned<RTCGeometry>> geometries_;
};

} // namespace

std::unique_ptr<EmbreeRefit> EmbreeRefit::create(const std::vector<MeshPtr>& meshes) {
    return std::make_unique<Refit>(meshes);
}

} // namespace prizma::bench

#else

namespace prizma::bench {

std::unique_ptr<EmbreeRefit> EmbreeRefit::create(const std::vector<MeshPtr>&) {
    return nullptr;
}

} // namespace prizma::bench

#endif
