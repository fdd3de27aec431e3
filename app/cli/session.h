// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/scene/scene.h"

namespace cli {

/// Exit codes, part of the contract with scripts (docs/command-line.md).
enum ExitCode : int {
    kDone = 0,
    kWrongUsage = 2,
    kUnusableInput = 3,
    kNoDevice = 4,
    kNotWritten = 5,
    kInterrupted = 130,  ///< SIGINT, as shells report it
};

/// The options that all commands share, and the chosen command.
struct Session {
    std::string device;         ///< part of a device's name or its index; "" = no wish
    std::string analysis;       ///< "auto", "cpu" or "gpu"; "" = no wish
    std::function<void()> run;  ///< set by the chosen command
};

// One function per command: declares its options and help, and sets `session.run` when it is chosen.
void addCreate(CLI::App& app, Session& session);
void addInfo(CLI::App& app, Session& session);
void addExport(CLI::App& app, Session& session);
void addSegment(CLI::App& app, Session& session);
void addRender(CLI::App& app, Session& session);
void addBrdf(CLI::App& app, Session& session);
void addDevices(CLI::App& app, Session& session);
void addBench(CLI::App& app, Session& session);

/// Reports progress to stderr (one rewritten line on a terminal, otherwise a line per step and tenth) and stops the
/// work on SIGINT.
[[nodiscard]] core::Progress printedProgress();
/// Ends the rewritten line, so that the next message starts on a new one.
void finishProgress();
/// Makes SIGINT stop the running step; a second one kills the program.
void catchInterrupts();

/// One sentence per line on stderr.
void printNotes(std::span<const core::Message> notes);
/// Loads a project and prints the notes about it.
[[nodiscard]] core::Scene loadScene(const std::string& project);

/// `text` as `count` numbers separated by commas; throws Error(Usage) naming the option.
[[nodiscard]] std::vector<float> parseNumbers(const std::string& option, const std::string& text, std::size_t count);
/// Splits "LABEL=VALUE" where names may contain "=": before a value in braces, otherwise at the last "=". Throws
/// Error(Usage) naming the option.
[[nodiscard]] std::pair<std::string, std::string> parseAssignment(const std::string& option, const std::string& text);
/// The segment with this label or name; throws Error(Usage) that lists the segments when there is none, or
/// more than one.
[[nodiscard]] core::Segment& requireSegment(core::Scene& scene, const std::string& labelOrName);
/// Throws Error(Usage) if writing `output` would replace the project or one of its input files.
void refuseOverwritingInput(const core::Scene& scene, const std::string& project, const std::string& output);

}  // namespace cli
