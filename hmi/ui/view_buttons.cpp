// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/view_buttons.hpp"

#include <QPushButton>

#include <functional>

#include "hmi/ui/flow_layout.hpp"
#include "hmi/ui/mesh_view.hpp"

namespace psicarve::ui {

FlowLayout* view_buttons(MeshView& view) {
    using Side = MeshView::Side;
    struct Button {
        const char* id;
        QString name;
        std::function<void()> act;
    };
    const Button buttons[] = {{"front", MeshView::tr("Front"), [&view] { view.look_from(Side::front); }},
                              {"side", MeshView::tr("Side"), [&view] { view.look_from(Side::side); }},
                              {"top", MeshView::tr("Top"), [&view] { view.look_from(Side::top); }},
                              {"iso", MeshView::tr("Iso"), [&view] { view.look_from(Side::iso); }},
                              {"fit", MeshView::tr("Fit"), [&view] { view.fit(); }}};
    auto* row = new FlowLayout;
    for (const auto& [id, name, act] : buttons) {
        auto* button = new QPushButton{name};
        button->setObjectName(QStringLiteral("%1_%2").arg(view.objectName(), id));
        button->setProperty("small", true);
        button->setFocusPolicy(Qt::TabFocus);
        QObject::connect(button, &QPushButton::clicked, &view, [act = act] { act(); });
        row->addWidget(button);
    }
    row->add_end();
    return row;
}

}  // namespace psicarve::ui
