// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/model_page.hpp"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QResizeEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QVBoxLayout>

#include <utility>

#include "hmi/phrase/warning_phrase.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/session/mesh_text.hpp"
#include "hmi/ui/flow_layout.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/mesh_view.hpp"
#include "hmi/ui/model_form.hpp"
#include "hmi/ui/model_report_dialog.hpp"
#include "hmi/ui/pass_view.hpp"
#include "hmi/ui/piece_panel.hpp"
#include "hmi/ui/refusal_card.hpp"
#include "hmi/ui/side_panels.hpp"
#include "hmi/ui/slicing_panel.hpp"
#include "hmi/ui/turn_form.hpp"
#include "hmi/ui/view_buttons.hpp"
#include "hmi/ui/warning_list.hpp"
#include "hmi/ui/words.hpp"
#include "hmi/ui/work_bar.hpp"

namespace psicarve::ui {
namespace {

constexpr int kFormWidth = PassView::kWidth_px;
constexpr int kLeastForBoth = 480;
constexpr int kLeastFieldsHeight = 120;

}  // namespace

/// The form's fields: beside the view as high as is left, for the page is not to scroll for what scrolls by
/// itself, and never lower than what stands below them may count on.
class ModelPage::FieldsRoom : public QScrollArea {
public:
    void set_beside(bool is_beside) {
        if (std::exchange(is_beside_, is_beside) != is_beside) updateGeometry();
    }
    QSize sizeHint() const override {
        const QSize all = QScrollArea::sizeHint();
        return is_beside_ ? QSize{all.width(), kLeastFieldsHeight} : all;
    }

private:
    bool is_beside_ = false;
};

ModelPage::ModelPage(WindowContext& context, Drawing drawing, Open open, QWidget* parent)
    : QWidget(parent),
      context_(context),
      watch_(kReachable_rgb, kUndercut_rgb),
      view_(new MeshView{drawing}) {
    setObjectName("model_page");
    sides_ = new QBoxLayout{QBoxLayout::LeftToRight, this};
    sides_->setContentsMargins(kGap, kGap, kGap, kGap);
    sides_->setSpacing(kGap);
    QWidget* const view = make_view();
    sides_->addWidget(view, 1);
    sides_->addWidget(make_form());
    context_.open_job.set_table_way([this] { return table_way(); });
    work_ = new WorkBar{context_, {room_->widget(), [this] { slice(); }, std::move(open)}};
    static_cast<QVBoxLayout*>(view->layout())->insertWidget(0, work_);
}

void ModelPage::resizeEvent(QResizeEvent* event) {
    // The form stands below the view where both do not fit side by side.
    const bool is_narrow = event->size().width() < kLeastForBoth;
    whole_form_->setMaximumWidth(is_narrow ? QWIDGETSIZE_MAX : kFormWidth);
    room_->set_beside(!is_narrow);
    sides_->setDirection(is_narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    place_refusal();
    QWidget::resizeEvent(event);
}

/// Beside its button, or where there is no room for that above the fields, which scroll.
void ModelPage::place_refusal() {
    const bool is_in_fields = field_rows_->indexOf(&slicing_->refusal()) >= 0;
    const bool is_small = room_in(window()->size()) == Room::small;
    if (is_small == is_in_fields) return;
    if (is_small) return field_rows_->insertWidget(0, &slicing_->refusal());
    field_rows_->removeWidget(&slicing_->refusal());
    slicing_->take_refusal_back();
}

void ModelPage::show_new_refusal() {
    const auto& refusal = context_.open_job.refusal();
    const bool is_of_slicing = refusal && refusal->of == session::OpenJobRefusal::Of::slicing;
    if (is_of_slicing && context_.open_job.mesh() && changes_ != sliced_changes_) {
        context_.open_job.forget_refusal();
        slicing_->refresh(is_stale());
    }
    const bool is_there = context_.open_job.refusal().has_value();
    if (is_there && !is_refusal_seen_) room_->verticalScrollBar()->setValue(0);
    is_refusal_seen_ = is_there;
}

QWidget* ModelPage::make_view() {
    auto* whole = new QWidget;
    auto* column = new QVBoxLayout{whole};
    column->setContentsMargins(0, 0, 0, 0);
    view_->setObjectName("model_view");
    view_->show_file_axes(true);
    view_->set_lasting(true);
    piece_ = new PiecePanel{*view_, [this] { show_model(); }};
    auto* shown = new FlowLayout;
    piece_->add_buttons(*shown);
    shown->add_end();
    report_button_ = new QPushButton{tr("Report…")};
    report_button_->setObjectName("model_report_open");
    report_button_->setProperty("small", true);
    report_button_->setFocusPolicy(Qt::TabFocus);
    connect(report_button_, &QPushButton::clicked, this, [this] { open_report(); });
    shown->addWidget(report_button_);
    column->addLayout(shown);
    auto* above = view_buttons(*view_);
    show_hidden_ = new QPushButton{tr("Undercut")};
    show_hidden_->setObjectName("view_undercut");
    show_hidden_->setProperty("small", true);
    show_hidden_->setFocusPolicy(Qt::TabFocus);
    connect(show_hidden_, &QPushButton::clicked, this, [this] {
        if (shown_view_ && shown_view_->hidden_view) view_->look_as(*shown_view_->hidden_view);
    });
    above->addWidget(show_hidden_);
    column->addLayout(above);
    column->addWidget(view_, 1);
    column->addWidget(piece_);
    warnings_ = new WarningList;
    column->addWidget(warnings_);
    return whole;
}

QWidget* ModelPage::make_form() {
    whole_form_ = new QWidget;
    whole_form_->setMinimumWidth(kFormWidth);
    auto* column = new QVBoxLayout{whole_form_};
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(role_label("head", tr("Placement and slicing")));
    column->addWidget(rule());
    form_ = new ModelForm{[this] { look(); },
                          [this] {
                              if (!is_taking_)
                                  context_.open_job.reshape(form_->flat_options(context_.machine_profile()));
                          }};
    turn_ = new TurnForm{[this] {
                             if (!is_taking_) turn_model();
                         },
                         [this] {
                             form_->set_fits(turn_->fits());
                             look();
                         }};
    auto* fields = new QWidget;
    fields_ = fields;
    auto* rows = new QVBoxLayout{fields};
    field_rows_ = rows;
    rows->setContentsMargins(0, 0, kSmallGap, 0);
    rows->addWidget(turn_);
    rows->addWidget(form_);
    size_ = role_label("label");
    size_->setObjectName("mesh_facts");
    size_->setWordWrap(true);  // beside the view's buttons it would be wider than a small screen
    rows->addWidget(size_);
    rows->addStretch();
    room_ = new FieldsRoom;
    room_->setObjectName("model_fields");
    room_->setWidgetResizable(true);
    room_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    room_->setFrameShape(QFrame::NoFrame);
    room_->setWidget(fields);
    room_->setMinimumHeight(kLeastFieldsHeight);
    column->addWidget(room_, 1);
    watch_fields(*fields);
    column->addWidget(form_->pass_picture());
    slicing_ = new SlicingPanel{context_,
                                {[this] { slice(); }, [this] { reload(); },
                                 [this](const session::Remedy& remedy) { take_remedy(remedy); }}};
    column->addWidget(slicing_);
    return whole_form_;
}

/// A job that was sliced otherwise than its fields say now is told from one that is up to date.
void ModelPage::watch_fields(QWidget& fields) {
    const auto note = [this] { ++changes_; };
    for (auto* box : fields.findChildren<QComboBox*>())
        connect(box, &QComboBox::currentIndexChanged, this, note);
    for (auto* box : fields.findChildren<QAbstractButton*>())
        connect(box, &QAbstractButton::toggled, this, note);
    for (auto* number : fields.findChildren<QSpinBox*>())
        connect(number, &QSpinBox::valueChanged, this, note);
    for (auto* number : fields.findChildren<QDoubleSpinBox*>())
        connect(number, &QDoubleSpinBox::valueChanged, this, note);
}

/// What the form says about the placement is seen at once; what cannot be reached, when it is found out.
void ModelPage::look() {
    const auto scene = context_.open_job.scene();
    if (!piece_->is_chosen()) show_model();
    show_facts();
    if (scene)
        watch_.look(context_.open_job.mesh(), scene, form_->profile_for(context_.machine_profile()),
                    options());
    else
        watch_.forget();
}

void ModelPage::show_model() {
    view_->set_up(form_->options().up);
    view_->set_blank({});
    view_->set_legend({});
    legend_.clear();
    view_->replace_scene(context_.open_job.scene());
    shown_view_.reset();
}

void ModelPage::set_theme(const Tokens& tokens) {
    view_->set_theme(tokens);
    warnings_->set_theme(tokens);
    slicing_->set_theme(tokens);
    form_->set_theme(tokens);
    refresh();
}

void ModelPage::refresh() {
    if (is_taking_) return;
    form_->show_passes(context_.machine_profile());
    slicing_->refresh(is_stale());
    show_new_refusal();
    if (shown_edition_ != context_.open_job.edition()) {
        shown_edition_ = context_.open_job.edition();
        show_opened();
        show_warnings();
    }
    turn_->show_what_applies(context_.open_job.kind(), form_->is_engraved(),
                             context_.open_job.table_way().has_value());
    turn_model();
    keep_engraving_cut();
    watch_.poll(report_ != nullptr);
    refit();
    refresh_piece();
    refresh_report();
    show_view();
    show_legend();
    show_blank();
    show_reasons();
    show_why_empty();
    work_->refresh(changes_, is_stale());
}

void ModelPage::forget_work() {
    work_->forget();
}

void ModelPage::show_facts() {
    const auto scene = context_.open_job.scene();
    if (!scene) return size_->clear();
    QStringList lines;
    for (const session::Phrase& line :
         session::mesh_lines(*context_.open_job.mesh(), slice::placed(form_->options().up, scene->size)))
        lines += words(line);
    size_->setText(lines.join('\n'));
}

void ModelPage::show_view() {
    const auto seen = watch_.seen();
    if (!seen || seen == shown_view_ || piece_->is_chosen()) return;
    shown_view_ = seen;
    view_->replace_scene(seen->painted);
    shown_blank_.reset();
}

/// Where the form has it now; what it lacks is told before slicing.
void ModelPage::show_blank() {
    const auto seen = watch_.seen();
    const Profile profile = form_->profile_for(context_.machine_profile());
    // A job tells for itself.
    const bool has_told = context_.open_job.job() && !is_stale();
    // What was told of a model that is being looked at again stays until that is done.
    std::vector<std::string> warnings = blank_warnings_;
    if (has_told || !context_.open_job.mesh())
        warnings.clear();
    else if (seen)
        warnings = session::blank_warnings(seen->reach, profile);
    if (warnings != blank_warnings_) {
        blank_warnings_ = std::move(warnings);
        show_warnings();
    }
    if (!seen || seen != shown_view_ || piece_->is_chosen()) return;
    const session::BlankOutline blank = session::blank_outline(seen->reach, profile);
    if (shown_blank_ == blank) return;
    shown_blank_ = blank;
    const QString across = QString::fromStdString(session::number_text(blank.diameter_mm, 1));
    view_->set_blank(MeshView::Blank{
        seen->reach.axis, blank.centre, blank.radius, blank.low, blank.high,
        blank.is_chosen ? tr("blank ⌀ %1 mm").arg(across) : tr("least blank ⌀ %1 mm").arg(across)});
}

void ModelPage::show_warnings() {
    std::vector<std::string> all;
    if (context_.open_job.mesh()) all = context_.open_job.mesh()->warnings;
    const auto add = [&all](const std::vector<std::string>& more) {
        const auto others = session::other_warnings(more, all);
        all.insert(all.end(), others.begin(), others.end());
    };
    if (context_.open_job.job()) add(context_.open_job.job()->warnings);
    add(blank_warnings_);
    warning_count_ = all.size();
    warnings_->show_warnings(std::move(all));
}

}  // namespace psicarve::ui
