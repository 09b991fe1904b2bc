// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/anew_dialog.hpp"

#include <QCoreApplication>
#include <QImage>
#include <QMessageBox>
#include <QPixmap>
#include <QPushButton>

#include "hmi/session/action_lock.hpp"
#include "hmi/session/going_on.hpp"
#include "hmi/ui/bench.hpp"
#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/words.hpp"

namespace psicarve::ui {
namespace {

struct AnewWords {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::AnewDialog)
};

/// Unrolled, as page Layers shows it.
QPixmap picture_of(const cam::PreparedJob& job, std::uint32_t carved_layers) {
    constexpr std::uint32_t kRest_rgb = 0x8A93A0;  // seen on a light and on a dark ground
    const session::CarvedPicture picture = session::carved_picture(job, carved_layers, kRest_rgb);
    const QImage image{reinterpret_cast<const uchar*>(picture.rgb.data()), static_cast<int>(picture.columns),
                       static_cast<int>(picture.rows), QImage::Format_RGB32};
    constexpr QSize kShown{144, 112};
    return QPixmap::fromImage(image.copy().scaled(kShown));  // the numbers go with this function
}

}  // namespace

bool asked_to_begin_anew(const Bench& bench, QWidget* window) {
    const auto piece = session::unfinished_piece(bench.machine.sight(), bench.desk.sight());
    if (!piece || piece->carved_layers == 0) return true;
    QMessageBox box{
        QMessageBox::Question, AnewWords::tr("Start anew"),
        words(session::anew_question(*piece)) + QStringLiteral("\n\n") +
            AnewWords::tr(
                "On this piece that takes time and cuts nothing. A new blank has to begin with layer 1."),
        QMessageBox::NoButton, window};
    box.setObjectName("anew_question");
    if (const auto job = bench.desk.core_job()) box.setIconPixmap(picture_of(*job, piece->carved_layers));
    QPushButton* go = box.addButton(AnewWords::tr("Start from layer 1"), QMessageBox::AcceptRole);
    go->setObjectName("anew_go");
    QPushButton* none = box.addButton(AnewWords::tr("Cancel"), QMessageBox::RejectRole);
    none->setObjectName("anew_cancel");
    box.setDefaultButton(none);
    run_dialog(box);
    // A minute may have passed.
    return box.clickedButton() == go && !bench.replay.is_open() &&
           !session::lock_of(session::Action::from_layer, bench.machine.sight(), bench.desk.sight());
}

}  // namespace psicarve::ui
