// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QPointer>
#include <QVariantMap>
#include <QWidget>

#include <functional>

#include "hmi/session/model_watch.hpp"
#include "hmi/ui/space_canvas.hpp"
#include "hmi/ui/window_context.hpp"

class QBoxLayout;
class QVBoxLayout;
class QLabel;
class QPushButton;

namespace psicarve::ui {

class MeshView;
class ModelForm;
class ModelReportDialog;
class PiecePanel;
class SlicingPanel;
class TurnForm;
class WarningList;
class WorkBar;
struct Tokens;

/// The model, how it is to stand and be sliced, and what was noticed about it. Its members: panels and
/// widgets, and what they show, so that it draws only what has changed.
class ModelPage : public QWidget {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::ModelPage)
public:
    /// Opens a file as every one is opened, with what forbids that.
    using Open = std::function<void(const QString& path)>;
    ModelPage(WindowContext& context, Drawing drawing, Open open, QWidget* parent = nullptr);

    void set_theme(const Tokens& tokens);
    void refresh();
    void slice();
    /// The form for what is on the desk, and whether its job is as the form has it.
    struct Work {
        QVariantMap fields;
        std::string path;
        BlankProfile fitted_blank;
        std::uint64_t changes = 0;
        std::uint64_t sliced_changes = 0;
    };
    Work work() const;
    /// Until take_work(): what is on the desk stays as it is, whatever the fields say.
    void await_work() noexcept { is_taking_ = true; }
    /// Goes on with that of a page before this one, which is gone.
    void take_work(const Work& kept);
    /// The window goes in order: nothing is to be taken up again.
    void forget_work();
    /// What was noticed about model and job.
    std::size_t warning_count() const noexcept { return warning_count_; }

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    class FieldsRoom;

    static constexpr std::uint32_t kReachable_rgb = 0xC2C8CE;
    static constexpr std::uint32_t kUndercut_rgb = 0xFFC21A;

    QWidget* make_view();
    QWidget* make_form();
    bool is_stale() const;
    void show_opened();
    void show_facts();
    void reload();
    void open_report();
    void place_refusal();
    void show_new_refusal();
    void take_remedy(const session::Remedy& remedy);
    void look();
    void show_model();
    void refresh_piece();
    void refresh_report();
    cam::JobOptions options() const;
    session::TableWay table_way() const;
    void turn_model();
    void watch_fields(QWidget& fields);
    void keep_engraving_cut();
    void refit();
    void show_view();
    void show_legend();
    void show_reasons();
    void show_why_empty();
    std::optional<double> sliced_undercut();
    void show_blank();
    void show_warnings();

    WindowContext& context_;
    session::ModelWatch watch_;
    std::shared_ptr<const session::ModelWatch::Seen> shown_view_;
    QString legend_;
    QString why_empty_;
    replay::JobPointer counted_job_;  ///< that the share is of
    std::optional<double> counted_share_;
    std::optional<session::BlankOutline> shown_blank_;
    std::vector<std::string> blank_warnings_;
    std::shared_ptr<const session::MeshScene> opened_;
    std::string opened_path_;
    std::uint64_t shown_edition_ = ~std::uint64_t{0};
    MeshView* view_;
    QBoxLayout* sides_ = nullptr;
    QWidget* whole_form_ = nullptr;
    FieldsRoom* room_ = nullptr;
    QWidget* fields_ = nullptr;  ///< in that room
    bool is_taking_ = false;     ///< fields are filled in that say what is so already
    QVBoxLayout* field_rows_ = nullptr;
    bool is_refusal_seen_ = false;
    PiecePanel* piece_ = nullptr;
    std::size_t warning_count_ = 0;
    BlankProfile fitted_blank_;  ///< that the model was last made to fit
    std::uint64_t changes_ = 0;  ///< of the fields
    std::uint64_t sliced_changes_ = 0;
    QLabel* size_;
    WarningList* warnings_;
    ModelForm* form_ = nullptr;
    TurnForm* turn_ = nullptr;
    QPushButton* show_hidden_ = nullptr;
    QPushButton* report_button_ = nullptr;
    QPointer<ModelReportDialog> report_;
    session::Phrase no_piece_;  ///< why there is no piece to be expected
    SlicingPanel* slicing_ = nullptr;
    WorkBar* work_ = nullptr;
};

}  // namespace psicarve::ui
