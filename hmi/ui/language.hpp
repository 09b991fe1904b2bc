// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QTranslator>

#include <array>
#include <cstdint>
#include <optional>

namespace psicarve::ui {

enum class Language : std::uint8_t { english, chinese, russian };

struct LanguageName {
    Language language;
    const char* code;  ///< as in the catalogue's file name and in --language
    const char* own;   ///< what its speakers call it, UTF-8
};

inline constexpr std::array<LanguageName, 3> kLanguages{{{Language::english, "en", "English"},
                                                         {Language::chinese, "zh_CN", "简体中文"},
                                                         {Language::russian, "ru", "Русский"}}};

/// The language with this code; a code's country or script may differ (zh, ru_RU).
std::optional<Language> language_of(const QString& code);
/// The first of the desktop's languages that there is a catalogue for, else English.
Language desktop_language();

/// Our catalogue, which has no contexts: the same English words are the same words everywhere.
class Catalogue : public QTranslator {
public:
    QString translate(const char* context, const char* text, const char* note, int count) const override;
};

/// From here on texts come in this language, ours and Qt's own. Texts that a window has already stay as they
/// are until its views are made anew. Needs the application.
void use_language(Language language);
/// The last that was asked for.
Language used_language();

}  // namespace psicarve::ui
