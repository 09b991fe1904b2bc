// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QDialog>

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "hmi/session/calibration_form.hpp"
#include "hmi/session/profile_files.hpp"
#include "hmi/ui/action_button.hpp"
#include "hmi/ui/window_context.hpp"

class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QStackedWidget;
class QTableWidget;

namespace psicarve::ui {

/// Asks for what is measured at the heads, step by step, shows what it makes of the machine's profile, and
/// writes that. Stays open beside the window, whose panels bring the heads to the pin. Its members: the
/// profile as read and as measured, and widgets.
class CalibrationDialog : public QDialog {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::CalibrationDialog)
public:
    /// The page that edits the profile, too.
    struct Page {
        std::function<std::optional<session::Phrase>()> lock;  ///< what it does with the file just now
        std::function<void()> written;                         ///< called once the file is another
    };
    CalibrationDialog(WindowContext& context, Page page, QWidget* parent = nullptr);

    /// Begins anew with the profile in this file once that is read; a message when it cannot be.
    void open_for(const std::string& path);
    /// Its file is being read or written.
    std::optional<session::Phrase> file_lock() const { return desk_.lock(); }
    bool is_saving() const noexcept { return desk_.is_saving(); }
    /// At screen rate, open or not.
    void poll() { desk_.poll(); }
    void refresh();

private:
    struct Step {
        QLineEdit* diameter = nullptr;
        QLineEdit* counted = nullptr;
        QLineEdit* around = nullptr;
        QLineEdit* up = nullptr;
        QLineEdit* wear = nullptr;
        QLabel* outcome = nullptr;
    };
    static constexpr std::size_t kSteps = profile::kCalibrationSteps.size();

    QWidget* make_step(std::size_t index);
    QWidget* make_overview();
    QLayout* make_buttons();
    QLineEdit* add_field(QGridLayout& grid, const QString& name, const QString& id);
    void take_place(Axis head, QLineEdit& field);
    void reckon();
    void show_step(int index);
    void show_changes();
    void begin_with_what_was_read();
    void come_to_front();
    void write();
    void tell_written(const Result<void>& saved);
    std::optional<session::Phrase> busy() const;

    WindowContext& context_;
    Page page_;
    session::ProfileFiles desk_;
    profile::ProfileDraft opened_;
    std::optional<Profile> on_file_;
    std::array<Step, kSteps> steps_{};
    session::CalibrationOutcome outcome_;
    std::vector<ActionButton*> here_;
    QLabel* title_;
    QLabel* file_;
    QStackedWidget* pages_;
    QTableWidget* changes_;
    QLabel* reason_;
    QPushButton* back_;
    QPushButton* next_;
    QPushButton* shut_;
    ActionButton* write_;
};

}  // namespace psicarve::ui
