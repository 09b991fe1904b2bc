// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QSettings>
#include <QStringList>

#include <optional>
#include <string>

#include "hmi/ui/language.hpp"
#include "hmi/ui/tokens.hpp"
#include "shared/signal.hpp"

namespace psicarve::ui {

enum class ThemeChoice : std::uint8_t { system, light, dark };

/// What survives the window: its place, the files opened last, how it looks. Never anything that moves.
class WindowSettings {
public:
    WindowSettings();

    QByteArray geometry() const;
    void set_geometry(const QByteArray& geometry);
    ThemeChoice theme() const;
    void set_theme(ThemeChoice choice);
    /// None: the desktop's.
    std::optional<Language> language() const;
    void set_language(std::optional<Language> language);
    /// Newest first; only those that are still there.
    QStringList recent_files() const;
    void add_recent_file(const QString& path);
    QString last_folder() const;
    /// The operator's own zero of an axis [mm; psi: deg], of the machine behind a segment.
    std::optional<double> zero(const std::string& segment, Axis axis) const;
    void set_zero(const std::string& segment, Axis axis, std::optional<double> position);

private:
    QSettings store_;
};

/// The desktop's own choice when none was made.
Theme theme_of(ThemeChoice choice);

}  // namespace psicarve::ui
