// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/refusal_card.hpp"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <utility>

#include "hmi/ui/flow_layout.hpp"
#include "hmi/ui/frames.hpp"
#include "hmi/ui/icon.hpp"
#include "hmi/ui/lock_with.hpp"
#include "hmi/ui/long_names.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

using Kind = session::Remedy::Kind;

constexpr int kCardIconSide = 18;

}  // namespace

RefusalCard::RefusalCard(Act act, QWidget* parent)
    : QFrame(parent),
      act_(std::move(act)),
      icon_(new QLabel),
      title_(role_label("title")),
      why_(plain_label()),
      offered_(new QWidget) {
    setObjectName("desk_refusal");
    title_->setObjectName("desk_refusal_title");
    why_->setObjectName("desk_refusal_why");
    why_->setWordWrap(true);
    auto* grid = new QGridLayout{this};
    grid->setContentsMargins(kGap, kSmallGap, kGap, kSmallGap);
    grid->setSpacing(kSmallGap);
    grid->setColumnStretch(1, 1);
    grid->addWidget(icon_, 0, 0);
    grid->addWidget(title_, 0, 1);
    grid->addWidget(why_, 1, 0, 1, 2);
    new FlowLayout{offered_};
    offered_->layout()->setContentsMargins(0, 0, 0, 0);
    add_button(Kind::height, "remedy_height");
    add_button(Kind::scale, "remedy_scale");
    add_button(Kind::layers, "remedy_layers");
    add_button(Kind::best_axis, "remedy_axis");
    add_button(Kind::core_profile, "remedy_profile");
    grid->addWidget(offered_, 2, 0, 1, 2);
    hide();
}

void RefusalCard::add_button(Kind kind, const char* name) {
    auto* button = new QPushButton;
    button->setObjectName(name);
    button->setFocusPolicy(Qt::TabFocus);
    offered_->layout()->addWidget(button);
    const std::size_t place = offers_.size();
    offers_.push_back({{kind}, button});
    connect(button, &QPushButton::clicked, this, [this, place] { act_(offers_[place].remedy); });
}

void RefusalCard::set_theme(const Tokens& tokens) {
    icon_->setPixmap(glyph_pixmap(Glyph::triangle, kCardIconSide, tokens.warn));
}

void RefusalCard::show_refusal(const session::OpenJobRefusal* refusal, const QString& lock) {
    if (isHidden() == (refusal != nullptr)) setVisible(refusal != nullptr);
    if (refusal == nullptr) return;
    const bool is_slicing = refusal->of == session::OpenJobRefusal::Of::slicing;
    title_->setText(is_slicing ? tr("Not sliced") : tr("Not published"));
    QString why = words(refusal->why);
    const QString name = QString::fromStdString(refusal->name) + ": ";
    if (why.startsWith(name)) why.remove(0, name.size());
    why = breakable(why);
    if (why_->text() != why) why_->setText(why);
    offered_->setVisible(!refusal->remedies.empty());
    for (Offer& offer : offers_) {
        const auto found = std::ranges::find(refusal->remedies, offer.remedy.kind, &session::Remedy::kind);
        const bool is_there = found != refusal->remedies.end();
        if (offer.button->isHidden() == is_there) offer.button->setVisible(is_there);
        if (!is_there) continue;
        offer.remedy = *found;
        offer.button->setText(words(session::remedy_text(*found)));
        lock_with(*offer.button, lock, tr("Changes that, and slices again"));
    }
    setAccessibleName(title_->text());
    setAccessibleDescription(why_->text());
}

}  // namespace psicarve::ui
