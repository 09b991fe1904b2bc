// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/view_buttons.hpp"

#include <QPushButton>

#include <functional>
#include <utility>

#include "hmi/ui/flow_layout.hpp"
#include "hmi/ui/mesh_view.hpp"

namespace psicarve::ui {

FlowLayout* view_buttons(MeshView& view) {
    using Side = MeshView::Side;
    const std::pair<QString, std::function<void()>> buttons[] = {
        {MeshView::tr("Front"), [&view] { view.look_from(Side::front); }},
        {MeshView::tr("Side"), [&view] { view.look_from(Side::side); }},
        {MeshView::tr("Top"), [&view] { view.look_from(Side::top); }},
        {MeshView::tr("Iso"), [&view] { view.look_from(Side::iso); }},
        {MeshView::tr("Fit"), [&view] { view.fit(); }}};
    auto* row = new FlowLayout;
    for (const auto& [name, act] : buttons) {
        auto* button = new QPushButton{name};
        button->setProperty("small", true);
        button->setFocusPolicy(Qt::TabFocus);
        QObject::connect(button, &QPushButton::clicked, &view, [act = act] { act(); });
        row->addWidget(button);
    }
    row->add_end();
    return row;
}

}  // namespace psicarve::ui
