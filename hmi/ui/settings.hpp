// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QStringList>
#include <QVariant>

#include <optional>
#include <string>

#include "hmi/ui/language.hpp"
#include "hmi/ui/settings_store.hpp"
#include "hmi/ui/tokens.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::ui {

enum class ThemeChoice : std::uint8_t { system, light, dark };

/// What survives the window: its place, the files opened last, how it looks. Never anything that moves. Asks
/// and changes the store, which is to live longer.
class WindowSettings {
public:
    explicit WindowSettings(SettingsStore& store) : store_(store) {}

    QByteArray geometry() const;
    void set_geometry(const QByteArray& geometry);
    /// Of the window's pages, by its name.
    QString page() const;
    void set_page(const QString& page);
    /// Panels in frames of their own, and where those stand.
    bool is_floating(const QString& panel) const;
    void set_floating(const QString& panel, bool floats);
    QByteArray panel_geometry(const QString& panel) const;
    void set_panel_geometry(const QString& panel, const QByteArray& geometry);
    ThemeChoice theme() const;
    void set_theme(ThemeChoice choice);
    /// None: the desktop's.
    std::optional<Language> language() const;
    void set_language(std::optional<Language> language);
    /// Newest first, wherever they are by now: their disks are not asked.
    QStringList recent_files() const;
    void add_recent_file(const QString& path);
    QStringList recent_profiles() const;
    void add_recent_profile(const QString& path);
    QString last_folder() const;
    /// The operator's own zero of an axis [mm; psi: deg], of the machine behind a segment.
    std::optional<double> zero(const std::string& segment, Axis axis) const;
    void set_zero(const std::string& segment, Axis axis, std::optional<double> position);

    /// What was chosen in a field of the window; invalid: nothing was.
    QVariant option(const QString& name) const;
    void set_option(const QString& name, const QVariant& value);

private:
    QStringList recent(const char* list) const;
    void add_recent(const char* list, const QString& path);

    SettingsStore& store_;
};

/// The desktop's own choice when none was made.
Theme theme_of(ThemeChoice choice);

}  // namespace psicarve::ui
