// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/start_from_dialog.hpp"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

#include <cstdint>

#include "hmi/session/start_place.hpp"
#include "hmi/ui/anew_dialog.hpp"
#include "hmi/ui/window_context.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

using session::StartPlace;

struct StartFromWords {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::StartFromDialog)
};
using Words = StartFromWords;

QString from_layer_text(std::uint32_t layer, bool is_dry) {
    return (is_dry
                ? Words::tr("Dry run from layer %1: the heads go out and stay there, spindle off; Y goes to "
                            "the layer, then table and Y go as they would.")
                : Words::tr("Start from layer %1: the layers below are left as they are. The heads go out, "
                            "Y goes to the layer, then the heads go in at plunge speed."))
        .arg(layer + 1);
}

QString from_point_text(const StartPlace& place, bool is_dry) {
    return (is_dry
                ? Words::tr("Dry run from layer %1, point %2: the heads go out and stay there, spindle off; "
                            "table and Y go as they would from there.")
                : Words::tr("Start from layer %1, point %2: what comes before it is left as it is. The "
                            "heads go in at that very point, at plunge speed."))
        .arg(place.layer + 1)
        .arg(*place.point + 1);
}

QString go_text(const StartPlace& place, bool is_dry) {
    if (!place.point) {
        return (is_dry ? Words::tr("Start dry run from layer %1") : Words::tr("Start from layer %1"))
            .arg(place.layer + 1);
    }
    return (is_dry ? Words::tr("Start dry run from layer %1, point %2")
                   : Words::tr("Start from layer %1, point %2"))
        .arg(place.layer + 1)
        .arg(*place.point + 1);
}

QString question_text(const WindowContext& context, const StartPlace& place, bool is_dry) {
    QString text = place.point ? from_point_text(place, is_dry) : from_layer_text(place.layer, is_dry);
    const auto job = context.open_job.core_job();
    if (place.point && !is_dry && job && session::is_place_of(*job, place))
        text += QStringLiteral("\n\n") + words(session::approach_text(*job, place));
    const session::MachineView& view = context.machine.view();
    if (place.layer == 0 || view.resumable_layer != place.layer) return text;
    text += QStringLiteral("\n\n") + Words::tr("Layer %1 was the last that was finished.").arg(place.layer);
    return text;
}

}  // namespace

bool asked_to_start_from(const WindowContext& context, const StartPlace& place, session::RunKind kind,
                         QWidget* window) {
    const bool is_dry = kind == session::RunKind::dry;
    QMessageBox box{QMessageBox::Question, Words::tr("From layer"), question_text(context, place, is_dry),
                    QMessageBox::NoButton, window};
    QPushButton* go = box.addButton(go_text(place, is_dry), QMessageBox::AcceptRole);
    go->setObjectName("from_layer_go");
    QPushButton* none = box.addButton(Words::tr("Cancel"), QMessageBox::RejectRole);
    none->setObjectName("from_layer_cancel");
    box.setDefaultButton(none);
    return asked_of_this_piece(context, box, go);
}

}  // namespace psicarve::ui
