// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/latency_panel.hpp"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include <thread>

#include "hmi/report/latency_report.hpp"
#include "hmi/session/display_text.hpp"
#include "hmi/ui/choice_box.hpp"
#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/flow_layout.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/histogram_view.hpp"
#include "hmi/ui/lock_with.hpp"
#include "hmi/ui/words.hpp"
#include "shared/base/units.hpp"

namespace psicarve::ui {
namespace {

constexpr int kMostSeconds = 1'000'000;
constexpr int kUsualSeconds = 60;
constexpr int kLeastPeriod_us = 10;
constexpr int kMostPeriod_us = 1'000'000;
constexpr int kSpinWidth = 104;

QSpinBox* spin(const char* name, int least, int most, const QString& unit) {
    auto* box = new QSpinBox;
    ignore_wheel(box);
    box->setObjectName(name);
    box->setRange(least, most);
    box->setSuffix(" " + unit);
    box->setFixedWidth(kSpinWidth);
    return box;
}

QPushButton* small_button(const char* name, const QString& text) {
    auto* button = new QPushButton{text};
    button->setObjectName(name);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

}  // namespace

LatencyPanel::LatencyPanel(WindowContext& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      cpu_(new ChoiceBox),
      progress_(new QProgressBar),
      said_(role_label("label")),
      histogram_(new HistogramView),
      rows_(new QGridLayout) {
    setObjectName("latency_panel");
    said_->setObjectName("latency_said");
    said_->setWordWrap(true);
    progress_->setTextVisible(false);
    progress_->setAccessibleName(tr("Progress"));
    rows_->setHorizontalSpacing(2 * kGap);
    rows_->setVerticalSpacing(kSmallGap);
    rows_->setColumnStretch(1, 1);
    rows_->setColumnStretch(3, 1);
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(kGap);
    all->addWidget(histogram_, 1);
    all->addLayout(rows_);
    all->addLayout(make_wish());
    all->addWidget(progress_);
    all->addWidget(said_);
    if (context.latency.last()) show_result();
}

QLayout* LatencyPanel::make_wish() {
    seconds_ = spin("latency_seconds", 1, kMostSeconds, tr("s"));
    seconds_->setValue(kUsualSeconds);
    seconds_->setAccessibleName(tr("How long to measure"));
    period_ = spin("latency_period", kLeastPeriod_us, kMostPeriod_us, tr("µs"));
    period_->setValue(static_cast<int>(machine::LatencyOptions{}.period_us));
    period_->setAccessibleName(tr("Tick to measure with"));
    cpu_->setObjectName("latency_cpu");
    cpu_->setAccessibleName(tr("Processor of the tick"));
    cpu_->addItem(tr("processor: as the core"), QString{});
    cpu_->addItem(tr("any processor"), QStringLiteral("any"));
    for (unsigned i = 0; i < std::thread::hardware_concurrency(); ++i)
        cpu_->addItem(tr("processor %1").arg(i), QString::number(i));
    begin_ = new ActionButton{[this](const WindowContext& now) -> std::optional<session::Phrase> {
                                  if (context_.latency.is_measuring())
                                      return session::phrase("Measure: under way");
                                  return session::latency_lock(now.machine.view());
                              },
                              tr("Measure"), [this] { context_.latency.begin(options()); }};
    begin_->setObjectName("latency_begin");
    begin_->set_hint(tr("Runs the core's own tick loop with nothing in the tick; touches no machine"));
    end_ = small_button("latency_end", tr("End now"));
    connect(end_, &QPushButton::clicked, this, [this] { context_.latency.end(); });
    save_ = small_button("latency_save", tr("Save CSV…"));
    connect(save_, &QPushButton::clicked, this, [this] {
        const QString path =
            ask_where_to_save(this, tr("Save the measurement"), "latency.csv", tr("Tables (*.csv)"));
        if (!path.isEmpty()) save(path);
    });
    auto* row = new FlowLayout;
    for (QWidget* part :
         {static_cast<QWidget*>(seconds_), static_cast<QWidget*>(period_), static_cast<QWidget*>(cpu_),
          static_cast<QWidget*>(begin_), static_cast<QWidget*>(end_)})
        row->addWidget(part);
    row->add_end();
    row->addWidget(save_);
    return row;
}

machine::LatencyOptions LatencyPanel::options() const {
    machine::LatencyOptions options;
    options.seconds = static_cast<std::uint32_t>(seconds_->value());
    options.period_us = static_cast<std::uint32_t>(period_->value());
    options.cpu = cpu_->currentData().toString().toStdString();
    return options;
}

void LatencyPanel::set_theme(const Tokens& tokens) {
    histogram_->set_theme(tokens);
}

void LatencyPanel::save(const QString& path) {
    if (!context_.latency.last()) return;
    context_.files.save_text(path.toStdString(), report::latency_csv(context_.latency.last()->result));
}

void LatencyPanel::show_result() {
    while (QLayoutItem* item = rows_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    constexpr int kColumns = 2;
    int place = 0;
    for (const session::LatencyRow& row : session::latency_rows(*context_.latency.last())) {
        const int column = 2 * (place % kColumns);
        auto* const name = role_label("label", words(row.name));
        name->setWordWrap(true);
        rows_->addWidget(name, place / kColumns, column);
        rows_->addWidget(plain_label(words(row.value)), place / kColumns, column + 1);
        ++place;
    }
    histogram_->show_health(session::latency_health(*context_.latency.last()));
}

void LatencyPanel::refresh() {
    const bool was_measuring = context_.latency.is_measuring();
    context_.latency.poll();
    const bool is_measuring = context_.latency.is_measuring();
    if (was_measuring && !is_measuring && context_.latency.last()) show_result();
    const QString locked = begin_->refresh(context_);
    lock_with(*end_, is_measuring ? QString{} : tr("End now: nothing is being measured"),
              tr("What was measured so far is the result"));
    lock_with(*save_, context_.latency.last() ? QString{} : tr("Save CSV: nothing was measured yet"));
    for (QWidget* part :
         {static_cast<QWidget*>(seconds_), static_cast<QWidget*>(period_), static_cast<QWidget*>(cpu_)})
        part->setEnabled(!is_measuring);
    progress_->setVisible(is_measuring);
    QString text = locked;
    if (is_measuring) {
        const machine::LatencyProgress now = context_.latency.progress();
        progress_->setRange(0, static_cast<int>(context_.latency.options().seconds));
        progress_->setValue(static_cast<int>(now.seconds));
        text = tr("%1 of %2 s, %3 missed, at most %4 late")
                   .arg(now.seconds)
                   .arg(context_.latency.options().seconds)
                   .arg(now.missed)
                   .arg(QString::fromStdString(session::duration_text(now.max_ns)));
    } else if (text.isEmpty()) {
        text = tr("Load the computer meanwhile as it will be loaded: an hour says more than a minute.");
    }
    if (said_->text() != text) said_->setText(text);
}

}  // namespace psicarve::ui
