// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/long_names.hpp"

#include <QFileInfo>

namespace psicarve::ui {

QString breakable(const QString& text) {
    constexpr qsizetype kLongest = 16;
    QString broken;
    qsizetype run = 0;
    for (const QChar letter : text) {
        run = letter.isSpace() ? 0 : run + 1;
        broken += letter;
        if (run % kLongest == 0 && run > 0) broken += QChar{0x200B};
    }
    return broken;
}

QString short_file_name(const std::string& path) {
    constexpr qsizetype kMost = 32;
    constexpr qsizetype kBegin = 18;
    const QString name = QFileInfo{QString::fromStdString(path)}.fileName();
    if (name.size() <= kMost) return name;
    return name.left(kBegin) + QChar{0x2026} + name.right(kMost - kBegin - 1);
}

}  // namespace psicarve::ui
