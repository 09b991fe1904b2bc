// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/settings.hpp"

#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QPalette>

#include <algorithm>

namespace psicarve::ui {
namespace {

constexpr int kMostRecent = 10;
constexpr const char* kGeometry = "window/geometry";
constexpr const char* kPage = "window/page";
constexpr const char* kTheme = "window/theme";
constexpr const char* kLanguage = "window/language";
constexpr const char* kRecent = "files/recent";
constexpr const char* kRecentProfiles = "profiles/recent";
/// "zero/psicarve/r1"
QString zero_key(const std::string& segment, Axis axis) {
    return QString{"zero/%1/%2"}.arg(QString::fromStdString(segment).remove('/'),
                                     QString::fromStdString(std::string{name_of(axis)}));
}

constexpr const char* kThemeNames[] = {"system", "light", "dark"};

}  // namespace

QByteArray WindowSettings::geometry() const {
    return store_.value(kGeometry).toByteArray();
}

void WindowSettings::set_geometry(const QByteArray& geometry) {
    store_.set(kGeometry, geometry);
}

QString WindowSettings::page() const {
    return store_.value(kPage).toString();
}

void WindowSettings::set_page(const QString& page) {
    store_.set(kPage, page);
}

bool WindowSettings::is_floating(const QString& panel) const {
    return store_.value("window/floats_" + panel).toBool();
}

void WindowSettings::set_floating(const QString& panel, bool floats) {
    store_.set("window/floats_" + panel, floats);
}

QByteArray WindowSettings::panel_geometry(const QString& panel) const {
    return store_.value("window/place_" + panel).toByteArray();
}

void WindowSettings::set_panel_geometry(const QString& panel, const QByteArray& geometry) {
    store_.set("window/place_" + panel, geometry);
}

ThemeChoice WindowSettings::theme() const {
    const QString name = store_.value(kTheme).toString();
    if (name == kThemeNames[1]) return ThemeChoice::light;
    return name == kThemeNames[2] ? ThemeChoice::dark : ThemeChoice::system;
}

void WindowSettings::set_theme(ThemeChoice choice) {
    store_.set(kTheme, kThemeNames[static_cast<int>(choice)]);
}

std::optional<Language> WindowSettings::language() const {
    return language_of(store_.value(kLanguage).toString());
}

void WindowSettings::set_language(std::optional<Language> language) {
    if (language) {
        store_.set(kLanguage, kLanguages[static_cast<std::size_t>(*language)].code);
    } else {
        store_.set(kLanguage, {});
    }
}

QStringList WindowSettings::recent(const char* list) const {
    return store_.value(list).toStringList();
}

void WindowSettings::add_recent(const char* list, const QString& path) {
    const QString whole = QFileInfo{path}.absoluteFilePath();
    store_.change({list, [whole](const QVariant& before) {
                       QStringList files = before.toStringList();
                       files.removeAll(whole);
                       files.prepend(whole);
                       while (files.size() > kMostRecent) files.removeLast();
                       return QVariant{files};
                   }});
}

QStringList WindowSettings::recent_files() const {
    return recent(kRecent);
}

void WindowSettings::add_recent_file(const QString& path) {
    add_recent(kRecent, path);
}

QStringList WindowSettings::recent_profiles() const {
    return recent(kRecentProfiles);
}

void WindowSettings::add_recent_profile(const QString& path) {
    add_recent(kRecentProfiles, path);
}

QString WindowSettings::last_folder() const {
    const QStringList files = recent_files();
    return files.isEmpty() ? QDir::homePath() : QFileInfo{files.front()}.absolutePath();
}

std::optional<double> WindowSettings::zero(const std::string& segment, Axis axis) const {
    bool is_number = false;
    const double position = store_.value(zero_key(segment, axis)).toDouble(&is_number);
    return is_number ? std::optional{position} : std::nullopt;
}

void WindowSettings::set_zero(const std::string& segment, Axis axis, std::optional<double> position) {
    if (position) {
        store_.set(zero_key(segment, axis), *position);
    } else {
        store_.set(zero_key(segment, axis), {});
    }
}

QVariant WindowSettings::option(const QString& name) const {
    return store_.value("options/" + name);
}

void WindowSettings::set_option(const QString& name, const QVariant& value) {
    store_.set("options/" + name, value);
}

Theme theme_of(ThemeChoice choice) {
    if (choice == ThemeChoice::light) return Theme::light;
    if (choice == ThemeChoice::dark) return Theme::dark;
    const QPalette palette = QGuiApplication::palette();
    const bool is_dark =
        palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
    return is_dark ? Theme::dark : Theme::light;
}

}  // namespace psicarve::ui
