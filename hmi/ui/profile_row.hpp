// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QFrame>

#include <cstddef>
#include <functional>

#include "hmi/profile/profile_draft.hpp"

class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;

namespace psicarve::ui {

/// One key of a profile: whether it is changed, its value to edit, bounds, default, and what is wrong with
/// it.
class ProfileRow : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::ProfileRow)
public:
    struct Events {
        std::function<void(const QString&)> typed;
        std::function<void()> looked_at;
    };
    /// With `in_full` the key is named with its table.
    ProfileRow(std::size_t key, bool in_full, Events events, QWidget* parent = nullptr);

    /// What stands in which column.
    static QWidget* header();
    /// With fewer columns where rows take two lines, none where they take three.
    static void arrange_header(QWidget& header, int lines);
    /// In one line; in two or three where a window is narrow.
    void arrange(int lines);

    std::size_t key() const noexcept { return key_; }
    /// `in_core`: the value of the core that runs, as it would be typed, where it is another one; else empty.
    void show_state(const profile::ProfileDraft& draft, const QString& in_core);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void make_editor();
    void show_marks(const profile::ProfileDraft& draft, const QString& in_core);

    std::size_t key_;
    Events events_;
    QLabel* changed_;
    QLineEdit* line_ = nullptr;
    QComboBox* words_ = nullptr;
    QLabel* name_;
    QLabel* unit_;
    QLabel* bounds_;
    QLabel* built_in_;
    QLabel* problem_;
    QGridLayout* grid_;
};

}  // namespace psicarve::ui
