// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// Marks an English text for translation that becomes the pattern of a Message elsewhere, for example in a table.
#define MESSAGE_TEXT(context, text) text

namespace core {

/// A setting that a message is about. Each program adds where its user finds it.
enum class Setting { None, DepthUnit, DepthUnitOrKind, FieldOfView };

/// A sentence for people, or a part of one: an English pattern with places %1 to %9 and the values for them. Core never
/// prints it; the command line says it in English, the window in the user's language.
///
/// `Message("messages", "Cannot read \"%1\": %2.").with(path, reason)` is what lupdate collects, so both texts have to
/// be literals there. A value is a message in turn: a reason is translated, a name or a number stays as it is.
class Message {
  public:
    /// Finds the translation of a pattern.
    using Translate = std::function<std::string(const char* context, const std::string& pattern)>;

    Message() = default;
    /// A text that is the same in every language.
    Message(std::string text) : pattern_(std::move(text)) {}  // NOLINT(google-explicit-constructor)
    Message(const char* text) : pattern_(text) {}             // NOLINT(google-explicit-constructor)
    template <std::integral T>
    Message(T number) : pattern_(std::to_string(number)) {}  // NOLINT(google-explicit-constructor)
    /// Six significant digits.
    template <std::floating_point T>
    Message(T number) : pattern_(shortNumber(static_cast<double>(number))) {}  // NOLINT(google-explicit-constructor)
    /// A pattern; `context` has static storage duration.
    Message(const char* context, std::string pattern) : context_(context), pattern_(std::move(pattern)) {}

    /// The same pattern with values for its places.
    template <class... Values>
    [[nodiscard]] Message with(Values&&... values) const {
        Message result = *this;
        (result.values_.emplace_back(std::forward<Values>(values)), ...);
        return result;
    }

    /// The same message, about a setting.
    [[nodiscard]] Message about(Setting setting) const;
    [[nodiscard]] Setting setting() const { return setting_; }

    [[nodiscard]] bool empty() const { return pattern_.empty(); }
    [[nodiscard]] std::string english() const;
    /// The sentence in another language. `translate` is asked for the pattern and for those of the values.
    [[nodiscard]] std::string text(const Translate& translate) const;
    /// Passes every pattern in it to `visit`, without the texts that are the same in every language.
    void visitPatterns(const std::function<void(const char* context, const std::string& pattern)>& visit) const;

    /// Whether they read the same.
    friend bool operator==(const Message& a, const Message& b) { return a.english() == b.english(); }

  private:
    [[nodiscard]] static std::string shortNumber(double number);

    const char* context_ = nullptr;  ///< nullptr: not to be translated
    std::string pattern_;
    std::vector<Message> values_;
    Setting setting_ = Setting::None;
};

/// Sentences for the user about something that succeeded.
using Notes = std::vector<Message>;

/// "a, b, c"; empty for an empty list.
[[nodiscard]] Message listed(std::span<const Message> items);

/// The English sentences.
[[nodiscard]] std::vector<std::string> english(std::span<const Message> messages);

}  // namespace core
