// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/refusal_bar.hpp"

#include <QLabel>
#include <QPushButton>

#include "hmi/ui/frames.hpp"
#include "hmi/ui/long_names.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
RefusalBar::RefusalBar(WindowContext& context, QWidget* parent)
    : NoticeBar("refusal", Glyph::triangle, parent),
      context_(context),
      why_(add_text("why")),
      stays_(add_text("stays")) {
    auto* read = new QPushButton{tr("Acknowledge")};
    read->setObjectName("refusal_read");
    read->setFocusPolicy(Qt::TabFocus);
    read->setToolTip(tr("Takes this away once it was read; it moves and stops nothing"));
    connect(read, &QPushButton::clicked, this, [this] {
        context_.forget_refused_file();
        refresh();
    });
    add_button(read);
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

/// An operator who expects another file on the machine is to know what is there.
QString RefusalBar::what_stays() const {
    if (const auto job = context_.open_job.core_job(); job && !context_.replay.is_open())
        return breakable(tr("The machine still has its job of before: Start carves %1.")
                             .arg(QString::fromStdString(std::string{job->view.source_name()})));
    const std::string open =
        context_.replay.is_open() ? context_.replay.facts().path : context_.open_job.path();
    return open.empty() ? QString{} : breakable(tr("Still open: %1").arg(short_file_name(open)));
}

void RefusalBar::refresh() {
    const session::RefusedFile* const refused = context_.refused_file();
    set_shown(refused != nullptr);
    if (refused == nullptr) return;
    show_text(title(), title_of(*refused));
    show_text(*why_, why_of(*refused));
    for (QLabel* label : {&title(), why_}) set_plain_tip(*label, words(refused->why));  // with its folder
    show_text(*stays_, what_stays());
    setAccessibleName(title().text());
}

}  // namespace psicarve::ui
