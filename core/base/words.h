// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace core {

/// An enumerator in words.
template <class E>
struct Word {
    E value;
    const char* key;         ///< in project files and on the command line
    const char* label = "";  ///< for people, untranslated; "" where no window shows it
};

/// The words of an enumeration: a specialisation beside it has a static member `table`, one row per enumerator.
///
///     template <>
///     struct Words<Fresnel> {
///         static constexpr Word<Fresnel> table[] = {{Fresnel::None, "none"}, {Fresnel::Schlick, "schlick"}, ...};
///     };
template <class E>
struct Words;

/// Word of an enumerator; "" for a value without a row.
template <class E>
[[nodiscard]] constexpr const char* wordOf(E value) {
    for (const Word<E>& word : Words<E>::table)
        if (word.value == value) return word.key;
    return "";
}

/// Label of an enumerator; "" for a value without a row.
template <class E>
[[nodiscard]] constexpr const char* labelOf(E value) {
    for (const Word<E>& word : Words<E>::table)
        if (word.value == value) return word.label;
    return "";
}

/// Enumerator of a word; nullopt for an unknown one.
template <class E>
[[nodiscard]] constexpr std::optional<E> findWord(std::string_view key) {
    for (const Word<E>& word : Words<E>::table)
        if (key == word.key) return word.value;
    return std::nullopt;
}

/// All words of an enumeration, in the order of its table.
template <class E>
[[nodiscard]] std::vector<std::string> wordsOf() {
    std::vector<std::string> keys;
    for (const Word<E>& word : Words<E>::table) keys.emplace_back(word.key);
    return keys;
}

}  // namespace core
