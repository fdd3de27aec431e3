// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/session.h"

#include <unistd.h>

#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <optional>

#include "app/cli/words.h"
#include "core/io/project.h"
#include "core/material/brdf_file.h"
#include "core/scene/mask.h"

namespace cli {

namespace {

std::atomic<bool> interrupted{false};

extern "C" void onInterrupt(int) { interrupted.store(true); }

/// Progress of the current task on stderr.
class ProgressPrinter {
  public:
    void report(core::Task task, float fraction) {
        const std::lock_guard lock(mutex_);
        const int percent = static_cast<int>(std::lround(100 * std::clamp(fraction, 0.0f, 1.0f)));
        const bool newTask = task != task_;
        // Steps run in parallel, so reports may arrive out of order.
        if (!newTask && percent / (terminal_ ? 1 : 10) <= shown_) return;
        task_ = task;
        shown_ = percent / (terminal_ ? 1 : 10);
        if (terminal_) {
            std::fprintf(stderr, "\r\033[K%s %d %%", taskName(task), percent);
            open_ = true;
        } else {
            std::fprintf(stderr, "%s %d %%\n", taskName(task), shown_ * 10);
        }
        std::fflush(stderr);
    }
    void finish() {
        const std::lock_guard lock(mutex_);
        if (open_) std::fputs("\r\033[K", stderr);
        open_ = false;
        task_.reset();
        shown_ = -1;
    }

  private:
    std::mutex mutex_;
    const bool terminal_ = ::isatty(STDERR_FILENO) == 1;
    std::optional<core::Task> task_;
    int shown_ = -1;
    bool open_ = false;
};

ProgressPrinter& progressPrinter() {
    static ProgressPrinter printer;
    return printer;
}

}  // namespace

core::Progress printedProgress() {
    return core::Progress([](core::Task task, float fraction) { progressPrinter().report(task, fraction); },
                          &interrupted);
}

void finishProgress() { progressPrinter().finish(); }

void catchInterrupts() {
    struct sigaction action {};
    action.sa_handler = onInterrupt;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
    sigaction(SIGINT, &action, nullptr);
}

void printNotes(std::span<const core::Message> notes) {
    for (const core::Message& note : notes) std::fprintf(stderr, "patina-cli: %s\n", sentence(note).c_str());
}

core::Scene loadScene(const std::string& project) {
    core::Notes notes;
    core::Scene scene = core::loadProject(project, &notes);
    printNotes(notes);
    return scene;
}

std::vector<float> parseNumbers(const std::string& option, const std::string& text, std::size_t count) {
    std::vector<float> numbers;
    const char* at = text.c_str();
    while (true) {
        char* end = nullptr;
        const float value = std::strtof(at, &end);
        if (end == at || !std::isfinite(value)) break;
        numbers.push_back(value);
        at = end;
        if (*at != ',') break;
        ++at;
    }
    if (*at != '\0' || numbers.size() != count)
        throw core::Error(core::ErrorKind::Usage, option + " is \"" + text + "\", expected " + std::to_string(count) +
                                                      " numbers separated by commas.");
    return numbers;
}

std::pair<std::string, std::string> parseAssignment(const std::string& option, const std::string& text) {
    std::size_t at = text.find('=');
    for (std::size_t k = at; k != std::string::npos; k = text.find('=', k + 1)) {
        const std::size_t value = text.find_first_not_of(" \t\r\n", k + 1);
        if (value == std::string::npos) break;
        at = k;
        if (text[value] == '{') break;
    }
    if (at == std::string::npos || at == 0)
        throw core::Error(core::ErrorKind::Usage, option + " is \"" + text + "\", expected LABEL=VALUE.");
    return {text.substr(0, at), text.substr(at + 1)};
}

core::Segment& requireSegment(core::Scene& scene, const std::string& labelOrName) {
    std::vector<core::Segment*> meant;
    std::string known;
    for (core::Segment& segment : scene.segments) {
        const std::string words = std::to_string(segment.label) + " \"" + segment.name + "\"";
        known += (known.empty() ? "" : ", ") + words;
        if (segment.name == labelOrName || std::to_string(segment.label) == labelOrName) meant.push_back(&segment);
    }
    if (meant.size() == 1) return *meant.front();
    if (meant.empty())
        throw core::Error(core::ErrorKind::Usage, "There is no segment \"" + labelOrName + "\"; the project has " +
                                                      (known.empty() ? "none" : known) + ".");
    throw core::Error(core::ErrorKind::Usage, "The segment \"" + labelOrName +
                                                  "\" is ambiguous: it is the label or the name of " +
                                                  std::to_string(meant.size()) + " segments; the project has " + known +
                                                  ". Use the label or the name that only one segment has.");
}

void refuseOverwritingInput(const core::Scene& scene, const std::string& project, const std::string& output) {
    const core::PhotoSource& source = scene.photo->source;
    std::vector<std::string> inputs{project,         source.color,           source.depth,
                                    source.segments, scene.environment.path, scene.backDepthPath};
    for (const core::Segment& segment : scene.segments) {
        if (!segment.edit) continue;
        for (const core::Drive& drive : segment.edit->drives)
            if (drive.mask) inputs.push_back(drive.mask->path());
    }
    for (const core::Segment& segment : scene.segments)
        if (segment.edit && segment.edit->brdfFile) inputs.push_back(segment.edit->brdfFile->path);
    for (const std::string& input : inputs) {
        std::error_code code;
        if (input.empty() || !std::filesystem::equivalent(input, output, code) || code) continue;
        throw core::Error(core::ErrorKind::Usage,
                          "The output \"" + output + "\" is an input of this project; choose another file.");
    }
}

}  // namespace cli
