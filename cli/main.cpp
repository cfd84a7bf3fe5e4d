#include "cli/commands.h"
#include "runtime/error.h"
#include "runtime/glsl/compiler.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <new>

#include <malloc.h>

namespace {

using namespace gnomon;

int run(int argc, char** argv) {
    cli::Common common;
    const char* folder = std::getenv("GNOMON_KERNELS");
    common.kernels = folder ? folder : GNOMON_SOURCE_DIR "/kernels";
    int exit_code = 0;

    CLI::App app{"gnomon examines shadow kernels: it runs each one alone against a reference, and all of "
                 "them together\n"
                 "against ray-traced truth.\n\n"
                 "  gnomon list                       what there is\n"
                 "  gnomon check smsr/case_09         is this kernel right?\n"
                 "  gnomon demo                       the whole tour, with pictures"};
    app.name("gnomon");
    app.require_subcommand(1);
    app.fallthrough();
    app.set_version_flag("--version", fmt::format("gnomon {}, {}", GNOMON_VERSION, glsl::version()));
    app.add_option("--device", common.device.name,
                   "Vulkan device, by index or part of its name (default: lavapipe)");
    app.add_option("--kernels", common.kernels, "folder with the kernels' GLSL files");
    app.add_flag("--validation", common.device.validation,
                 "turn Vulkan's validation layer on; any message is an error");
    app.add_option("--time-limit", common.device.time_limit, "seconds that one dispatch may take")
        ->check(CLI::Validator(
            [](std::string& text) {
                const double limit = std::strtod(text.c_str(), nullptr);
                return limit >= 0.001 && limit <= 1e6 ? "" : text + " is not between 0.001 and 1000000";
            },
            "SECONDS"))
        ->capture_default_str();

    app.parse_complete_callback(
        [&] { gpu::prepare_process(common.device.name.empty() && !app.got_subcommand("devices")); });

    cli::add_list(app, common);
    cli::add_describe(app, common);
    cli::add_witnesses(app, common);
    cli::add_check(app, common, exit_code);
    cli::add_eval(app, common);
    cli::add_revectorize(app, common);
    cli::add_render(app, common);
    cli::add_census(app, common, exit_code);
    cli::add_atlas(app, common, exit_code);
    cli::add_bench(app, common, exit_code);
    cli::add_worst(app, common, exit_code);
    cli::add_fuzz(app, common, exit_code);
    cli::add_reproduce(app, common);
    cli::add_demo(app, common, exit_code);
    cli::add_devices(app, common);

    if (argc > 1 && argv[1][0] != '-') {
        const std::vector<CLI::App*> verbs = app.get_subcommands([](const CLI::App*) { return true; });
        const auto known = [&](const CLI::App* verb) { return verb->get_name() == argv[1]; };
        if (std::none_of(verbs.begin(), verbs.end(), known)) {
            std::string names;
            for (const CLI::App* verb : verbs) names += " " + verb->get_name();
            throw Error("no verb \"{}\"; there are:{}", argv[1], names);
        }
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success))
            return app.exit(error); // --help
        fmt::print(stderr, "gnomon: {} (gnomon --help, or gnomon VERB --help, shows what there is)\n",
                   error.what());
        return 2;
    }
    return exit_code;
}

} // namespace

int main(int argc, char** argv) {
    // Buffers of a few MiB come and go with every kernel: keep their pages instead of faulting them in anew
    // each time.
    mallopt(M_MMAP_THRESHOLD, 1 << 30);
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    int exit_code = 2;
    try {
        exit_code = run(argc, argv);
    } catch (const gnomon::Error& error) {
        fmt::print(stderr, "gnomon: {}\n", error.what());
    } catch (const std::bad_alloc&) {
        fmt::print(
            stderr,
            "gnomon: not enough memory; make the image or shadow map smaller, or take fewer samples\n");
    } catch (const std::exception& error) {
        fmt::print(stderr, "gnomon: unexpected: {}\n", error.what());
    }
    // Everything that matters is written. Leaving without destructors spares the driver's slow farewell, and
    // is the only way out while a kernel loops for ever in one of its threads.
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        fmt::print(stderr, "gnomon: standard output could not be written to its end\n");
        exit_code = 2;
    }
    std::fflush(nullptr);
    std::_Exit(exit_code);
}
