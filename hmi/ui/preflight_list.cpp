// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/preflight_list.hpp"

#include <QGridLayout>
#include <QHBoxLayout>

#include <algorithm>

#include "hmi/ui/frames.hpp"
#include "hmi/ui/icon.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

using session::Check;

constexpr int kCheckIconSide = 14;

QString with_remedy(const Check& check) {
    const QString remedy = words(check.remedy);
    return remedy.isEmpty() ? words(check.detail) : QStringLiteral("%1; %2").arg(words(check.detail), remedy);
}

}  // namespace

QString to_look_at_in(const std::vector<Check>& checks) {
    QStringList named;
    for (const Check& check : checks) {
        if (check.verdict == Check::Verdict::warning)
            named << QStringLiteral("%1: %2").arg(words(check.name), words(check.detail));
    }
    return named.join(", ");
}

PreflightList::PreflightList(QWidget* parent)
    : QWidget(parent), title_(role_label("head")), sum_(role_label("head")), grid_(new QGridLayout) {
    auto* head = new QHBoxLayout;
    head->addWidget(title_);
    head->addStretch();
    head->addWidget(sum_);
    sum_->setObjectName("preflight_sum");
    grid_->setColumnStretch(1, 1);
    for (std::size_t i = 0; i < session::kMostChecks; ++i) {
        const Row row{new QLabel, plain_label(), role_label("label")};
        row.icon->setFixedSize(kCheckIconSide + 4, kCheckIconSide + 3);
        const int line = static_cast<int>(i);
        grid_->addWidget(row.icon, line, 0);
        grid_->addWidget(row.name, line, 1);
        grid_->addWidget(row.detail, line, 2, Qt::AlignRight);
        row.icon->setObjectName(QString{"preflight_icon_%1"}.arg(line));
        row.name->setObjectName(QString{"preflight_name_%1"}.arg(line));
        rows_.push_back(row);
    }
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(kSmallGap);
    all->addLayout(head);
    all->addWidget(rule());
    all->addLayout(grid_);
}

void PreflightList::set_low(bool is_low) {
    grid_->setVerticalSpacing(is_low ? 0 : 2);
}

void PreflightList::show_checks(const std::vector<Check>& checks) {
    title_->setText(tr("Pre-flight"));
    show_rows(checks);
    show_sum(checks);
    to_look_at_ = to_look_at_in(checks);
}

void PreflightList::show_contents(const std::vector<Check>& contents) {
    title_->setText(tr("In the recording"));
    show_rows(contents);
    sum_->clear();
    to_look_at_.clear();
}

void PreflightList::show_rows(const std::vector<Check>& checks) {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const bool is_there = i < checks.size();
        const Row& row = rows_[i];
        for (QLabel* label : {row.icon, row.name, row.detail}) label->setVisible(is_there);
        if (!is_there) continue;
        show_icon(row, checks[i].verdict);
        row.name->setText(words(checks[i].name));
        show_detail(row, words(checks[i].detail));
        const QString remedy = words(checks[i].remedy);
        set_plain_tip(*row.name, remedy);
        if (!remedy.isEmpty()) set_plain_tip(*row.detail, with_remedy(checks[i]));
    }
}

/// Each verdict has a shape and a word of its own besides its colour.
void PreflightList::show_icon(const Row& row, Check::Verdict verdict) const {
    struct Look {
        Glyph glyph;
        QColor colour;
        QString word;
    };
    const Look looks[] = {{Glyph::check, tokens_->run, tr("passed")},
                          {Glyph::cross, tokens_->alarm, tr("missing")},
                          {Glyph::info, tokens_->text2, tr("says nothing here")},
                          {Glyph::triangle, tokens_->warn, tr("to look at")}};
    const Look& look = looks[static_cast<std::size_t>(verdict)];
    const QString key = QString{"%1 %2"}.arg(static_cast<int>(look.glyph)).arg(look.colour.name());
    if (row.icon->property("look") == key) return;
    row.icon->setProperty("look", key);
    row.icon->setPixmap(glyph_pixmap(look.glyph, kCheckIconSide, look.colour));
    row.icon->setAccessibleName(look.word);
    row.icon->setToolTip(look.word);
}

/// As much as there is room for beside the name; all of it in the tooltip.
void PreflightList::show_detail(const Row& row, const QString& text) const {
    int names_width = 0;  // the widest has the others' details at its end, too
    for (const Row& each : rows_) {
        if (!each.name->isHidden()) names_width = std::max(names_width, each.name->sizeHint().width());
    }
    const int room = width() - 2 * grid_->horizontalSpacing() - row.icon->width() - names_width;
    const QString shown =
        row.detail->fontMetrics().elidedText(text, Qt::ElideMiddle, std::max(room, 4 * kGap));
    row.detail->setText(shown);
    set_plain_tip(*row.detail, shown == text ? QString{} : text);
}

/// What says nothing here counts neither way.
void PreflightList::show_sum(const std::vector<Check>& checks) {
    const auto count = [&checks](Check::Verdict verdict) {
        return std::count_if(checks.begin(), checks.end(),
                             [verdict](const Check& check) { return check.verdict == verdict; });
    };
    const auto passed = count(Check::Verdict::pass);
    const auto judged = static_cast<std::ptrdiff_t>(checks.size()) - count(Check::Verdict::info);
    const auto to_look_at = count(Check::Verdict::warning);
    sum_->setText(to_look_at > 0 ? tr("%1 of %2 pass, %3 to look at").arg(passed).arg(judged).arg(to_look_at)
                                 : tr("%1 of %2 pass").arg(passed).arg(judged));
    const QColor colour = count(Check::Verdict::fail) > 0 ? tokens_->alarm
                          : to_look_at > 0                ? tokens_->warn
                                                          : tokens_->run;
    const QString style = QString{"color: %1"}.arg(colour.name());
    if (sum_->styleSheet() != style) sum_->setStyleSheet(style);
}

}  // namespace psicarve::ui
