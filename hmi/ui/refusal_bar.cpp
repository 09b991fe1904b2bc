// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/refusal_bar.hpp"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "hmi/ui/frames.hpp"
#include "hmi/ui/icon.hpp"
#include "hmi/ui/long_names.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

constexpr int kRefusalIconSide = 24;
constexpr int kRefusalIconWidth = 40;

void show_text(QLabel& label, const QString& text) {
    if (label.text() != text) label.setText(text);
    if (label.isHidden() != text.isEmpty()) label.setVisible(!text.isEmpty());
}

}  // namespace

RefusalBar::RefusalBar(Bench& bench, QWidget* parent)
    : QFrame(parent),
      bench_(bench),
      icon_(new QLabel),
      title_(role_label("title")),
      why_(new QLabel),
      stays_(new QLabel) {
    setObjectName("refusal");
    title_->setObjectName("refusal_title");
    why_->setObjectName("refusal_why");
    stays_->setObjectName("refusal_stays");
    icon_->setFixedWidth(kRefusalIconWidth);
    icon_->setAlignment(Qt::AlignCenter);
    auto* text = new QVBoxLayout;
    text->setContentsMargins(0, kGap, kGap, kGap);
    text->setSpacing(3);
    for (QLabel* label : {title_, why_, stays_}) {
        label->setWordWrap(true);
        text->addWidget(label);
    }
    auto* read = new QPushButton{tr("Acknowledge")};
    read->setObjectName("refusal_read");
    read->setFocusPolicy(Qt::TabFocus);
    read->setToolTip(tr("Takes this away once it was read; it moves and stops nothing"));
    connect(read, &QPushButton::clicked, this, [this] {
        bench_.forget_refused_file();
        refresh();
    });
    auto* all = new QHBoxLayout{this};
    all->setContentsMargins(0, 0, kGap, 0);
    all->setSpacing(0);
    all->addWidget(icon_);
    all->addLayout(text, 1);
    all->addWidget(read, 0, Qt::AlignVCenter);
    setVisible(false);
}

void RefusalBar::set_theme(const Tokens& tokens) {
    icon_->setPixmap(glyph_pixmap(Glyph::triangle, kRefusalIconSide, tokens.warn));
    refresh();
}

QString RefusalBar::title_of(const session::RefusedFile& refused) {
    return breakable(tr("%1 was not opened").arg(short_file_name(refused.path)));
}

QString RefusalBar::why_of(const session::RefusedFile& refused) {
    QString why = words(refused.why);
    const QString name = QString::fromStdString(refused.path);
    if (why.startsWith(name + ": ")) why.remove(0, name.size() + 2);
    return breakable(why.replace(name, short_file_name(refused.path)));
}

/// Somebody who expects another file on the machine is to know what is there.
QString RefusalBar::what_stays() const {
    if (const auto job = bench_.desk.core_job(); job && !bench_.replay.is_open())
        return breakable(tr("The machine still has its job of before: Start carves %1.")
                             .arg(QString::fromStdString(std::string{job->view.source_name()})));
    const std::string open = bench_.replay.is_open() ? bench_.replay.facts().path : bench_.desk.path();
    return open.empty() ? QString{} : breakable(tr("Still open: %1").arg(short_file_name(open)));
}

void RefusalBar::refresh() {
    const session::RefusedFile* const refused = bench_.refused_file();
    if (isHidden() == (refused != nullptr)) setVisible(refused != nullptr);
    if (refused == nullptr) return;
    show_text(*title_, title_of(*refused));
    show_text(*why_, why_of(*refused));
    for (QLabel* label : {title_, why_}) label->setToolTip(words(refused->why));  // with its folder
    show_text(*stays_, what_stays());
    setAccessibleName(title_->text());
}

}  // namespace psicarve::ui
