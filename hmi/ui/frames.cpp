// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/frames.hpp"

#include <QEvent>
#include <QStyle>
#include <QTextDocument>

namespace psicarve::ui {
namespace {

/// Events of this kind change nothing in what it watches, and go on to what is behind it.
class EventIgnorer : public QObject {
public:
    EventIgnorer(QObject* watched, QEvent::Type type) : QObject(watched), type_(type) {}

private:
    bool eventFilter(QObject* /*watched*/, QEvent* event) override {
        if (event->type() != type_) return false;
        event->ignore();
        return true;
    }

    QEvent::Type type_;
};

}  // namespace

QLabel* plain_label(const QString& text) {
    auto* label = new QLabel;
    label->setTextFormat(Qt::PlainText);
    label->setText(text);
    return label;
}

QLabel* role_label(const char* role, const QString& text) {
    QLabel* label = plain_label(text);
    label->setProperty("role", role);
    return label;
}

QString plain_tip(const QString& text) {
    // A tool tip has no format to be set: what would be taken for HTML becomes such as says the same.
    return Qt::mightBeRichText(text) ? "<p>" + text.toHtmlEscaped().replace('\n', "<br>") + "</p>" : text;
}

void set_plain_tip(QWidget& widget, const QString& text) {
    const QString tip = plain_tip(text);
    if (widget.toolTip() != tip) widget.setToolTip(tip);
}

void set_styled(QWidget* widget, const char* property, const QVariant& value) {
    if (widget->property(property) == value) return;
    widget->setProperty(property, value);
    widget->style()->unpolish(widget);
    widget->style()->polish(widget);
}

QFrame* rule() {
    auto* line = new QFrame;
    line->setProperty("rule", true);
    return line;
}

Dock::Dock(const QString& title, QWidget* parent) : QFrame(parent) {
    setProperty("dock", true);
    auto* all = new QVBoxLayout{this};
    all->setContentsMargins(1, 1, 1, 1);
    all->setSpacing(0);
    auto* head = new QHBoxLayout;
    head->setContentsMargins(kGap, kSmallGap, kGap, kSmallGap);
    title_ = role_label("head", title);
    head->addWidget(title_);
    head->addStretch();
    note_ = role_label("small");
    head->addWidget(note_);
    all->addLayout(head);
    all->addWidget(rule());
    body_ = new QVBoxLayout;
    body_->setContentsMargins(kGap, kSmallGap, kGap, kGap);
    body_->setSpacing(kSmallGap);
    all->addLayout(body_, 1);
}

void ignore_wheel(QWidget* widget) {
    widget->installEventFilter(new EventIgnorer{widget, QEvent::Wheel});
}

void ignore_keys(QWidget* widget) {
    widget->installEventFilter(new EventIgnorer{widget, QEvent::KeyPress});
}

}  // namespace psicarve::ui
