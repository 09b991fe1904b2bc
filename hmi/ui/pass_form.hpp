// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

#include <optional>

#include "shared/profile/profile.hpp"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QString;
class QWidget;

namespace psicarve::ui {

class PassView;
struct Tokens;

/// Rows of a form about the passes before the finishing one, as `psicarve slice` takes them with --stepdown
/// and the options beside it, and a picture of what they come to with the tool and the blank.
class PassForm {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::PassForm)
public:
    PassForm(QFormLayout& form, QWidget& parent);

    /// The picture and what is to be said of it; the parent's until another takes it.
    QWidget* picture() const noexcept { return picture_; }
    void set_theme(const Tokens& tokens);
    /// Puts what was chosen into a profile that has its tool and its blank already.
    void fill(Profile& profile) const;
    /// What the fields come to with this machine, tool and blank. At screen rate.
    void show_for(const Profile& profile);

private:
    QDoubleSpinBox* field(const char* name, const QString& label, const QString& hint);
    void note_choice();
    void show_what_applies();

    QFormLayout& form_;
    QComboBox* choice_;
    QDoubleSpinBox* stepdown_ = nullptr;
    QDoubleSpinBox* allowance_ = nullptr;
    QDoubleSpinBox* stepover_ = nullptr;
    QWidget* picture_;
    PassView* view_;
    QLabel* note_;
    bool is_begun_ = false;         ///< the fields have been filled from the profile
    Profile machine_;               ///< that show_for was last told
    std::optional<Profile> shown_;  ///< of which picture and note tell
};

}  // namespace psicarve::ui
