#include "app/render/command.h"
#include "core/compute/worker_affinity.h"

int main(int argc, char** argv) {
    prizma::keepDeviceWorkersApart();
    CLI::App app{"Renders, inspects and measures Prizma scenes without a display.", "prizma-render"};
    app.require_subcommand(1);
    app.fallthrough(false);
    prizma::addDevicesCommand(app);
    prizma::addInfoCommand(app);
    prizma::addRenderCommand(app);
    prizma::addPoseCommand(app);
    prizma::addBenchCommand(app);
    CLI11_PARSE(app, argc, argv);
    return 0;
}
