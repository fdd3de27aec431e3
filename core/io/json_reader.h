// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/image.h"
#include "core/base/words.h"

namespace core {

/// Strict reading of one JSON object: every key is read with its type and range, and `finish` refuses the keys that
/// were never read. Errors name the key with its place ("segments[2].edit.alpha"), what was expected and what was
/// found. The object has to outlive the reader.
class JsonReader {
  public:
    /// `place` is the object's own key, "" for the document. Throws when `value` is not an object.
    JsonReader(const nlohmann::json& value, std::string place, ErrorKind kind);

    [[nodiscard]] bool has(const char* key) const { return object_->contains(key); }
    /// The value of an optional key, marked as known; nullptr when it is absent.
    [[nodiscard]] const nlohmann::json* find(const char* key);
    [[nodiscard]] std::string place(const std::string& key) const;

    // Each reads an optional key into `target`, which stays as it is when the key is absent.
    void read(const char* key, bool& target);
    void read(const char* key, std::string& target);
    void read(const char* key, float& target, float min, float max);
    void read(const char* key, double& target, double min, double max);
    void read(const char* key, int& target, int min, int max);
    void read(const char* key, std::int64_t& target, std::int64_t min, std::int64_t max);
    /// Three numbers, each in [min, max].
    void read(const char* key, Vector3f& target, float min, float max);
    /// Three numbers or one for all three.
    void readColorOrNumber(const char* key, Vector3f& target, float min, float max);
    /// Index of one of a list of words.
    [[nodiscard]] std::optional<std::size_t> readChoice(const char* key, const std::vector<std::string>& words);
    /// One of the words of an enumeration.
    template <class E>
    void readWord(const char* key, E& target) {
        if (const auto row = readChoice(key, wordsOf<E>())) target = Words<E>::table[*row].value;
    }

    /// Throws when a key is missing.
    void require(const char* key) const;
    /// Throws when a key was never read; `hint` is a sentence that ends the message.
    void finish(const Message& hint = {}) const;

    [[noreturn]] void fail(const std::string& key, const Message& expected, const nlohmann::json& found) const;
    [[noreturn]] void fail(const Message& sentence) const;
    [[nodiscard]] ErrorKind kind() const { return kind_; }

  private:
    [[nodiscard]] double number(const std::string& key, const nlohmann::json& value, double min, double max) const;

    const nlohmann::json* object_;
    std::string place_;
    ErrorKind kind_;
    std::set<std::string> known_;
};

/// Parses a JSON document. Throws Error(kind) with line and column on a syntax error or a key that occurs twice.
[[nodiscard]] nlohmann::json parseJson(std::string_view text, ErrorKind kind);

/// `"a", "b"`.
[[nodiscard]] std::string quotedList(const std::vector<std::string>& words);

/// Shortest decimal number that reads back as the same float.
[[nodiscard]] double toJson(float value);
[[nodiscard]] nlohmann::json toJson(const Vector3f& v);

}  // namespace core
