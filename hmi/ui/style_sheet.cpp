// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "hmi/ui/tokens.hpp"

namespace psicarve::ui {
namespace {

// @name stands for a token's colour.
constexpr const char* kSheet = R"(
* { font-family: "Noto Sans", "DejaVu Sans"; font-size: 13px; color: @text; outline: none; }
QMainWindow, QDialog, #window { background: @win; }
#strip, #statusbar { background: @panel; border: 0; }
#strip { border-bottom: 1px solid @line; }
QFrame[dock="true"] { background: @panel; border: 1px solid @line; border-radius: 4px; }
QLabel { background: transparent; border: 0; }
QFrame[axis_row="true"] { border: 0; }
QFrame[axis_row="true"][selected="yes"] { background: @sel; }
QFrame[axis_row="true"]:focus { border: 2px solid @text; }
QFrame[jog_armed="yes"] { border: 2px solid @warn_fill; }
#wiring { border: 0; border-left: 4px solid @line; background: @panel; }
#wiring[armed="yes"] { border-left: 4px solid @warn_fill; background: @warn_ground; }
QLabel[role="armed"] { color: @warn; font-weight: 700; font-size: 11px; }
QLabel[role="head"] { color: @text2; font-weight: 700; font-size: 12px; }
QLabel[role="small"] { color: @text2; font-size: 11px; }
QLabel[role="label"] { color: @text2; font-size: 12px; }
QLabel[role="r1"] { color: @r1; font-weight: 700; font-size: 12px; }
QLabel[role="r2"] { color: @r2; font-weight: 700; font-size: 12px; }
QLabel[role="axis"] { font-size: 16px; font-weight: 700; }
QLabel[role="digits"] { font-size: 28px; }
QLabel[role="digits"][long="yes"] { font-size: 17px; }
QLabel[role="title"] { font-size: 15px; font-weight: 700; }
QLabel[role="percent"] { font-size: 18px; font-weight: 700; }
QLabel[role="badge"] { color: @sim; border: 2px solid @sim; border-radius: 4px; font-weight: 700; padding: 0 10px; }
QLabel[role="port"] { color: @text; border: 1px solid @edge; border-radius: 4px; font-weight: 700; padding: 0 10px; }
QLabel[role="estop"] { color: @on_fill; font-weight: 700; font-size: 14px; }
QLabel[role="estop_second"] { color: @on_fill; font-size: 11px; }
QLabel[lamp="off"] { color: @text2; border: 1px solid @line; border-radius: 3px; font-size: 11px; padding: 0 4px; }
QLabel[lamp="good"] { color: @run; border: 1px solid @run; border-radius: 3px; font-size: 11px; padding: 0 4px; }
QLabel[lamp="unsure"] { color: @warn; border: 1px dashed @warn; border-radius: 3px; font-size: 11px; padding: 0 4px; }
QLabel[lamp="bad"] { color: @on_fill; background: @alarm_fill; border: 1px solid @alarm_fill; border-radius: 3px;
    font-size: 11px; font-weight: 700; padding: 0 4px; }
QFrame[rule="true"] { background: @line; border: 0; max-height: 1px; min-height: 1px; }
QPushButton, QToolButton { background: @raised; border: 1px solid @edge; border-radius: 4px; padding: 0 6px;
    min-height: 30px; }
QPushButton:hover, QToolButton:hover { border-color: @text2; }
QPushButton:pressed, QToolButton:pressed, QPushButton:checked { background: @sel; border-color: @text; }
QPushButton:focus, QToolButton:focus { border: 2px solid @text; }
QPushButton[head="r1"] { color: @r1; }
QPushButton[head="r2"] { color: @r2; }
QPushButton:disabled, QPushButton[head="r1"]:disabled, QPushButton[head="r2"]:disabled { color: @dis; background: @panel; border-color: @line; }
QPushButton:checked { font-weight: 700; }
QPushButton[key="true"] { min-height: 34px; padding: 0 2px; }
QPushButton[main="true"] { background: @run_fill; color: @on_fill; border-color: @run_fill; font-weight: 700; min-height: 38px; }
QPushButton[main="true"]:disabled { background: @panel; color: @dis; border-color: @line; }
QPushButton[strong="true"] { font-weight: 700; min-height: 38px; padding: 0 2px; }
QDialogButtonBox QPushButton { min-width: 60px; }
QPushButton[low="yes"] { min-height: 30px; }
QPushButton[narrow="true"] { padding: 0 2px; }
QPushButton[lines="two"] { min-height: 38px; }
QPushButton[small="true"] { min-height: 22px; padding: 0 6px; }
QPushButton[estop="true"] { background: @alarm_fill; color: @on_fill; border: 3px solid @warn_fill; border-radius: 4px;
    font-weight: 700; font-size: 13px; padding: 0 4px; min-height: 50px; }
QPushButton[estop="true"]:pressed { background: @alarm; color: @win; }
QCheckBox:disabled { color: @dis; }
QCheckBox::indicator { width: 14px; height: 14px; background: @field; border: 1px solid @edge; border-radius: 3px; }
QCheckBox::indicator:checked { background: @sel; border-color: @text; }
QCheckBox::indicator:focus { border: 2px solid @text; width: 12px; height: 12px; }
QCheckBox::indicator:disabled { background: @panel; border-color: @line; }
QMenuBar, QMenu { background: @panel; border: 1px solid @line; }
QMenu::item { padding: 5px 24px; }
QMenu::item:selected { background: @sel; }
QMenu::item:disabled { color: @dis; }
QMenu::separator { height: 1px; background: @line; }
QTabWidget::pane { border: 0; border-top: 1px solid @line; background: @panel; }
QTabBar { background: @panel; }
QTabBar::tab { background: @panel; color: @text2; padding: 7px 14px; border: 0; border-bottom: 3px solid @panel; }
QTabBar::tab:selected { color: @text; font-weight: 700; border-bottom: 3px solid @text; }
#side_names::tab, QTabBar[narrow="yes"]::tab { padding: 7px 8px; }
QTabBar QLabel[badge] { background: @warn_fill; color: @on_warn; border-radius: 8px; font-size: 11px; font-weight: 700;
    min-width: 8px; min-height: 16px; max-height: 16px; padding: 0 5px; }
QTabBar QLabel[badge="alarm"] { background: @alarm_fill; color: @on_fill; }
QTabBar::scroller { width: 44px; }
QTabBar QToolButton { background: @raised; border: 1px solid @edge; }
QTabBar::tab:focus { color: @text; }
QLineEdit, QSpinBox, QDoubleSpinBox, QComboBox { background: @field; border: 1px solid @edge; border-radius: 3px;
    min-height: 26px; padding: 0 4px; selection-background-color: @sel; selection-color: @text; }
QLineEdit:focus, QSpinBox:focus, QDoubleSpinBox:focus, QComboBox:focus { border: 2px solid @text; }
QLineEdit[invalid="true"], QComboBox[invalid="true"] { border: 2px solid @alarm; }
QFrame[invalid="true"] { background: @alarm_ground; }
QLabel[role="problem"] { color: @alarm; font-size: 12px; }
QScrollArea, #profile_sheet { background: @field; border: 1px solid @line; }
#profile_sheet { border: 0; }
#pages, #side_pages QScrollArea, #model_fields, #keys_room { background: @panel; border: 0; }
#pages > QWidget, #pages QStackedWidget, #side_pages QScrollArea > QWidget { background: @panel; }
#keys_room > QWidget, #keys_room > QWidget > QWidget, #model_fields > QWidget, #model_fields > QWidget > QWidget { background: @panel; }
#message_room, #message_room > QWidget, #message_room > QWidget > QWidget { background: transparent; border: 0; }
QListWidget { background: @field; border: 1px solid @line; }
QListWidget::item { padding: 6px 8px; }
QListWidget::item:selected { background: @sel; color: @text; font-weight: 700; }
QSpinBox:disabled, QDoubleSpinBox:disabled, QComboBox:disabled { color: @dis; background: @panel; border-color: @line; }
QSpinBox::up-button, QSpinBox::down-button, QDoubleSpinBox::up-button, QDoubleSpinBox::down-button { width: 0; border: 0; }
QComboBox::drop-down { border: 0; width: 18px; }
QComboBox QAbstractItemView { background: @field; border: 1px solid @edge; selection-background-color: @sel;
    selection-color: @text; }
QProgressBar { background: @field; border: 1px solid @edge; border-radius: 3px; min-height: 12px; max-height: 12px; }
QProgressBar::chunk { background: @run_fill; }
QProgressBar[tone="warn"]::chunk { background: @warn_fill; }
QProgressBar[tone="alarm"]::chunk { background: @alarm_fill; }
QProgressBar[tone="replay"]::chunk { background: @sim_fill; }
QSlider::groove:horizontal { height: 4px; background: @line; border-radius: 2px; }
QSlider::sub-page:horizontal { height: 4px; background: @text2; border-radius: 2px; }
QSlider::handle:horizontal { background: @text; width: 10px; margin: -6px 0; border-radius: 2px; }
QSlider::groove:vertical { width: 4px; background: @line; border-radius: 2px; }
QSlider::add-page:vertical { width: 4px; background: @text2; border-radius: 2px; }
QSlider::handle:vertical { background: @text; height: 10px; margin: 0 -8px; border-radius: 2px; }
QSlider::handle:disabled { background: @dis; }
QTableView, QTableWidget { background: @field; border: 1px solid @line; gridline-color: @line;
    alternate-background-color: @field; selection-background-color: @sel; selection-color: @text; }
QHeaderView::section { background: @panel; color: @text2; border: 0; border-bottom: 1px solid @line; padding: 4px 6px; }
QScrollBar:vertical { background: @panel; width: 10px; }
QScrollBar::handle:vertical { background: @edge; border-radius: 4px; min-height: 24px; }
QScrollBar:horizontal { background: @panel; height: 10px; }
QScrollBar::handle:horizontal { background: @edge; border-radius: 4px; min-width: 24px; }
QScrollBar::add-line, QScrollBar::sub-line { height: 0; width: 0; }
QToolTip { background: @field; color: @text; border: 1px solid @edge; padding: 3px; }
QFrame[notice="true"], #desk_refusal { background: @warn_ground; border: 2px solid @warn; border-radius: 4px; }
QLabel[trouble="yes"] { color: @warn; font-weight: 700; }
#alarm_room, #alarm_room > QWidget, #alarm_room > QWidget > QWidget { background: transparent; border: 0; }
*[text_room="true"], *[text_room="true"] > QWidget, *[text_room="true"] > QWidget > QWidget { background: transparent; border: 0; }
#banner { background: @alarm_ground; border: 2px solid @alarm; border-radius: 4px; }
)";

// For a hand that stands further off.
constexpr const char* kWideSheet = R"(
QLabel[role="digits"] { font-size: 36px; }
QLabel[role="digits"][long="yes"] { font-size: 24px; }
QPushButton { min-height: 34px; }
QPushButton[key="true"] { min-height: 50px; }
QPushButton[main="true"], QPushButton[strong="true"] { min-height: 46px; }
QTableView::item, QTableWidget::item { padding: 2px 0; }
)";

}  // namespace

QString style_sheet(const Tokens& tokens, bool is_wide) {
    // Longer names first: @warn is the beginning of @warn_fill.
    const std::pair<const char*, QColor> colours[] = {{"@alarm_ground", tokens.alarm_ground},
                                                      {"@alarm_fill", tokens.alarm_fill},
                                                      {"@alarm", tokens.alarm},
                                                      {"@warn_ground", tokens.warn_ground},
                                                      {"@warn_fill", tokens.warn_fill},
                                                      {"@warn", tokens.warn},
                                                      {"@run_fill", tokens.run_fill},
                                                      {"@run", tokens.run},
                                                      {"@raised", tokens.raised},
                                                      {"@r1", tokens.r1},
                                                      {"@r2", tokens.r2},
                                                      {"@sel", tokens.sel},
                                                      {"@sim_fill", tokens.sim_fill},
                                                      {"@sim", tokens.sim},
                                                      {"@text2", tokens.text2},
                                                      {"@text", tokens.text},
                                                      {"@on_fill", tokens.on_fill},
                                                      {"@on_warn", tokens.on_warn},
                                                      {"@panel", tokens.panel},
                                                      {"@field", tokens.field},
                                                      {"@line", tokens.line},
                                                      {"@edge", tokens.edge},
                                                      {"@dis", tokens.dis},
                                                      {"@win", tokens.win}};
    QString sheet = QString::fromLatin1(kSheet) + QString::fromLatin1(is_wide ? kWideSheet : "");
    for (const auto& [name, colour] : colours) sheet.replace(QLatin1String(name), colour.name());
    return sheet;
}

}  // namespace psicarve::ui
