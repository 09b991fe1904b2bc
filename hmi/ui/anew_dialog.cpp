// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/anew_dialog.hpp"

#include <QCoreApplication>
#include <QImage>
#include <QMessageBox>
#include <QPixmap>
#include <QPushButton>
#include <QTimer>

#include <chrono>
#include <cstdint>
#include <optional>

#include "hmi/session/action_lock.hpp"
#include "hmi/session/going_on.hpp"
#include "hmi/ui/dialogs.hpp"
#include "hmi/ui/window_context.hpp"
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

/// What a question is about.
struct AskedPiece {
    std::optional<session::UnfinishedPiece> piece;
    std::uint64_t job_generation = 0;

    friend bool operator==(const AskedPiece&, const AskedPiece&) = default;
};

AskedPiece asked_piece(const WindowContext& context) {
    const session::MachineView& machine_view = context.machine.view();
    return {session::unfinished_piece(machine_view, context.open_job.view()),
            machine_view.status ? machine_view.status->job_generation : 0};
}

bool may_still_start(const WindowContext& context, const AskedPiece& asked) {
    return !context.replay.is_open() && asked_piece(context) == asked &&
           !session::lock_of(session::Action::from_layer, context.machine.view(), context.open_job.view());
}

QString anew_text(const session::UnfinishedPiece& piece, bool is_dry) {
    if (is_dry) {
        return AnewWords::tr(
            "Dry run from layer 1: the heads go out and stay there, spindle off; table and Y go as they "
            "would. "
            "Nothing is cut, and where the piece goes on stays known.");
    }
    QString text = words(session::anew_question(piece)) + QStringLiteral("\n\n");
    return text + (piece.carved_layers == 0
                       ? AnewWords::tr("A new blank has to begin with layer 1.")
                       : AnewWords::tr("On this piece that takes time and cuts nothing. A new blank has to "
                                       "begin with layer 1."));
}

}  // namespace

bool asked_of_this_piece(const WindowContext& context, QMessageBox& box, const QPushButton* go) {
    constexpr std::chrono::milliseconds kLook{30};
    const AskedPiece asked = asked_piece(context);
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &box, [&] {
        if (!may_still_start(context, asked)) box.reject();
    });
    look.start(kLook);
    run_dialog(box);
    return box.clickedButton() == go && may_still_start(context, asked);
}

bool asked_to_begin_anew(const WindowContext& context, session::RunKind kind, QWidget* window) {
    const auto piece = session::unfinished_piece(context.machine.view(), context.open_job.view());
    if (!piece) return true;
    const bool is_dry = kind == session::RunKind::dry;
    QMessageBox box{QMessageBox::Question, AnewWords::tr("Start anew"), anew_text(*piece, is_dry),
                    QMessageBox::NoButton, window};
    box.setObjectName("anew_question");
    // Of roughed layers there is nothing to be seen in it.
    if (const auto job = context.open_job.core_job();
        job && piece->carved_layers > job->view.finishing_layer())
        box.setIconPixmap(picture_of(*job, piece->carved_layers));
    QPushButton* go = box.addButton(
        is_dry ? AnewWords::tr("Start dry run from layer 1") : AnewWords::tr("Start from layer 1"),
        QMessageBox::AcceptRole);
    go->setObjectName("anew_go");
    QPushButton* none = box.addButton(AnewWords::tr("Cancel"), QMessageBox::RejectRole);
    none->setObjectName("anew_cancel");
    box.setDefaultButton(none);
    return asked_of_this_piece(context, box, go);
}

}  // namespace psicarve::ui
