// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

#include "hmi/session/phrase.hpp"

namespace psicarve::ui {

/// A phrase in the operator's language.
inline QString words(const session::Phrase& text) {
    const QString translated = QCoreApplication::translate("session", text.english);
    return QString::fromStdString(session::filled_in(translated.toStdString(), text.arguments));
}

}  // namespace psicarve::ui
