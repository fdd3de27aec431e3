// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>

#include "app/cli/session.h"
#include "app/cli/words.h"
#include "gpu/error.h"

namespace {

int exitCode(core::ErrorKind kind) {
    switch (kind) {
        case core::ErrorKind::Usage:
            return cli::kWrongUsage;
        case core::ErrorKind::Input:
            return cli::kUnusableInput;
        case core::ErrorKind::Output:
            return cli::kNotWritten;
        case core::ErrorKind::Cancelled:
            return cli::kInterrupted;
    }
    return cli::kUnusableInput;
}

int report(const std::string& message, int code) {
    cli::finishProgress();
    std::fprintf(stderr, "patina-cli: %s\n", message.c_str());
    return code;
}

/// Runs the chosen command and checks that its output was written.
int run(const cli::Session& session) {
    try {
        cli::catchInterrupts();
        session.run();
        cli::finishProgress();
        std::cout.flush();
        if (!std::cout || std::fflush(stdout) != 0)
            return report("Cannot write to the standard output.", cli::kNotWritten);
        return cli::kDone;
    } catch (const core::Error& error) {
        return report(cli::sentence(error.message()), exitCode(error.kind()));
    } catch (const gpu::Error& error) {
        return report(error.what(), cli::kNoDevice);
    } catch (const std::bad_alloc&) {
        return report("There is not enough memory for these images.", cli::kUnusableInput);
    } catch (const std::exception& error) {
        return report(error.what(), cli::kUnusableInput);
    }
}

}  // namespace

int main(int argc, char** argv) {
    cli::Session session;
    CLI::App app("Patina changes the materials of objects in photographs with depth.", "patina-cli");
    app.set_version_flag("--version", "patina-cli " PATINA_VERSION);
    app.add_option("--device", session.device,
                   "Graphics device: part of its name or its number in `patina-cli devices`")
        ->type_name("DEVICE");
    app.add_option("--analysis", session.analysis,
                   "Where the analysis runs: auto (the graphics device, unless it is a software one), cpu or gpu")
        ->type_name("WHERE");
    app.require_subcommand(1);
    app.fallthrough();
    app.footer(
        "Exit codes: 0 done, 2 wrong usage, 3 unusable input, 4 no usable device or device lost, 5 could not write.\n"
        "`patina-cli COMMAND --help` explains a command.");
    cli::addCreate(app, session);
    cli::addInfo(app, session);
    cli::addExport(app, session);
    cli::addSegment(app, session);
    cli::addRender(app, session);
    cli::addBrdf(app, session);
    cli::addDevices(app, session);
    cli::addBench(app, session);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        return app.exit(success);
    } catch (const CLI::ParseError& error) {
        app.exit(error);
        return cli::kWrongUsage;
    }
    return run(session);
}
