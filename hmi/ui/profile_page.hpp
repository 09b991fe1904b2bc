// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QWidget>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "hmi/session/profile_files.hpp"
#include "hmi/session/snapshot_compare.hpp"
#include "hmi/ui/action_button.hpp"
#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"

class QBoxLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace psicarve::ui {

class CalibrationDialog;
class ProfileRow;

/// The machine profile, key by key: typed values are checked at once, and what is saved keeps the file's
/// comments and a backup. The machine's own profile is the one that its core was started with. Its members:
/// rows, widgets, and the values of the core that stand beside them.
class ProfilePage : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::ProfilePage)
public:
    explicit ProfilePage(WindowContext& context, QWidget* parent = nullptr);
    ~ProfilePage() override;

    void set_theme(const Tokens& tokens);
    void refresh();
    // What comes of these three is a message; until then the page says what is under way.
    void open(const QString& path);
    /// Without a dialog.
    void save_as(const QString& path);
    void save();
    /// Asks for what is measured at the heads; a message says what is in the way.
    void calibrate();
    /// Asks, when something was typed that is not saved, or not yet.
    bool may_lose_changes();
    /// Which of the files that its menus offer are there.
    void look_for_files();
    const profile::ProfileDraft& draft() const noexcept { return context_.profile_desk.draft(); }
    std::size_t problem_count() const { return draft().problem_count(); }

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    struct Group {
        std::string table;  ///< "axis.r1"; empty: keys of the top
        QString title;
    };

    void make_groups();
    void arrange();
    QWidget* make_head();
    QWidget* make_foot();
    void make_menus();
    std::optional<session::Phrase> busy_lock() const;
    bool is_saving() const;
    void open_again();
    void show_opened(const Result<void>& opened);
    void show_other();
    void ask_open();
    void ask_save_as();
    void ask_save();
    /// Asks whether these become so in the file.
    bool may_save(const std::vector<session::DifferenceRow>& changes);
    void show_rows();
    bool belongs(std::size_t key) const;
    bool is_filtered() const;
    QString why_no_rows() const;
    void show_changed();
    void type(std::size_t key, const QString& text);
    void show_state();
    void show_locks();
    // profile_page_core.cpp
    void look_at_core();
    QString in_core(std::size_t key) const;
    QString restart_text() const;
    void explain(std::size_t key);
    void report(const Result<void>& saved);
    QString lock() const;
    bool has_backup() const;
    bool is_kept(const QString& reason);
    QString busy_text() const;
    QString unsaved_text() const;

    WindowContext& context_;
    const Tokens* tokens_ = nullptr;
    std::vector<Group> groups_;
    std::vector<std::string> core_values_;  ///< of profile_keys(), of the core that runs; empty: not known
    std::uint64_t core_hash_ = 0;           ///< of the profile that they are of
    std::vector<ProfileRow*> rows_;         ///< those that are shown
    QLabel* file_;
    QLabel* changes_;
    QLineEdit* find_;
    QPushButton* only_changed_;
    QPushButton* compare_;
    QBoxLayout* middle_ = nullptr;
    QWidget* header_ = nullptr;
    int row_lines_ = 0;  ///< none as yet
    QListWidget* list_;
    QScrollArea* area_;
    QLabel* explanation_;
    QLabel* reason_;
    QPushButton* open_;
    QPushButton* undo_;
    QPushButton* restore_;
    QPushButton* save_;
    QPushButton* save_as_;
    ActionButton* calibrate_;
    CalibrationDialog* calibration_ = nullptr;  ///< once it was asked for
};

}  // namespace psicarve::ui
