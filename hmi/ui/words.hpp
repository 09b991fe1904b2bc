// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QDateTime>
#include <QString>

#include <chrono>
#include <string>
#include <vector>

#include "hmi/phrase/phrase.hpp"

namespace psicarve::ui {

/// A phrase in the operator's language. Words of the core that stand in it come along where there are any.
inline QString words(const session::Phrase& text) {
    const auto translated = [](const char* context, const std::string& english) {
        return QCoreApplication::translate(context, english.c_str()).toStdString();
    };
    std::vector<std::string> arguments;
    for (const std::string& argument : text.arguments) arguments.push_back(translated("core", argument));
    for (const session::Phrase& inner : text.inner) arguments.push_back(words(inner).toStdString());
    return QString::fromStdString(session::filled_in(translated("session", text.english), arguments));
}

/// By the operator's clock; the format is QDateTime's.
inline QString local_time(std::chrono::system_clock::time_point time, const char* format) {
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
    return QDateTime::fromMSecsSinceEpoch(ms).toString(QLatin1String{format});
}

}  // namespace psicarve::ui
