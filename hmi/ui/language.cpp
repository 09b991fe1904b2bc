// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/language.hpp"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>

#include <memory>

// In a static library nothing else asks for them; the macro wants no namespace around it.
static void take_in_catalogues() {
    Q_INIT_RESOURCE(translations);
}

namespace psicarve::ui {
namespace {

constexpr const char* kContext = "psicarve";

const char* code_of(Language language) {
    return kLanguages[static_cast<std::size_t>(language)].code;
}

Language& used() {
    static Language language = Language::english;
    return language;
}

void take_down(std::unique_ptr<QTranslator>& translator) {
    if (translator != nullptr) QCoreApplication::removeTranslator(translator.get());
    translator.reset();
}

}  // namespace

std::optional<Language> language_of(const QString& code) {
    for (const LanguageName& name : kLanguages) {
        if (code.compare(QLatin1String(name.code), Qt::CaseInsensitive) == 0) return name.language;
    }
    const QString bare = code.section(QLatin1Char('_'), 0, 0).section(QLatin1Char('-'), 0, 0);
    // Traditional characters are not what the catalogue has.
    if (bare == QLatin1String("zh") && (code.contains("TW") || code.contains("HK") || code.contains("Hant")))
        return std::nullopt;
    for (const LanguageName& name : kLanguages) {
        if (bare == QString::fromLatin1(name.code).section(QLatin1Char('_'), 0, 0)) return name.language;
    }
    return std::nullopt;
}

Language desktop_language() {
    const QStringList wanted = QLocale::system().uiLanguages();
    for (const QString& code : wanted) {
        if (const auto language = language_of(code)) return *language;
    }
    return Language::english;
}

QString Catalogue::translate(const char* /*context*/, const char* text, const char* /*note*/,
                             int count) const {
    return QTranslator::translate(kContext, text, nullptr, count);
}

Language used_language() {
    return used();
}

void use_language(Language language) {
    used() = language;
    static std::unique_ptr<QTranslator> of_qt;
    static std::unique_ptr<QTranslator> ours;
    take_down(of_qt);
    take_down(ours);
    if (language == Language::english) return;
    of_qt = std::make_unique<QTranslator>();
    const QString code = QLatin1String(code_of(language));
    // Dialogs of Qt's own; without the package that has them they stay English.
    if (of_qt->load("qtbase_" + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(of_qt.get());
    take_in_catalogues();
    ours = std::make_unique<Catalogue>();
    if (ours->load(":/translations/psicarve_" + code + ".qm"))
        QCoreApplication::installTranslator(ours.get());
}

}  // namespace psicarve::ui
