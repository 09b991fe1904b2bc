// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QCoreApplication>
#include <QString>

#include <cstdint>
#include <vector>

#include "hmi/ui/tokens.hpp"
#include "hmi/ui/window_context.hpp"

namespace psicarve::ui {

/// What a row of messages is chosen by.
struct MessageFilter {
    /// In the order of the box. A refused command is a warning, and a command, too.
    enum class Kind : std::uint8_t { all, alarms, warnings, commands, information };

    Kind kind = Kind::all;
    bool with_earlier_runs = true;
    QString text{};

    bool takes(const session::Message& message) const;
    bool operator==(const MessageFilter&) const = default;
};

/// The messages that a filter takes, newest first: those of this window, then what the journal has of before.
/// Texts are made when they are shown: 7000 rows cost nothing.
class MessageModel : public QAbstractTableModel {
    Q_DECLARE_TR_FUNCTIONS(psicarve::ui::MessageModel)
public:
    enum Column : int { kTime, kKind, kAxes, kWhat, kRemedy, kColumns };
    /// Stays with its message, whatever comes above it.
    struct Row {
        bool is_earlier = false;
        std::uint64_t number = 0;  ///< earlier: in the history; else as the log counts
        bool operator==(const Row&) const = default;
    };

    explicit MessageModel(const WindowContext& context) : context_(context) {}

    void set_theme(const Tokens& tokens);
    void set_filter(MessageFilter filter);
    /// Takes what is new; true: there was something.
    bool refresh();
    const Row& row(int index) const { return rows_[static_cast<std::size_t>(index)]; }
    /// -1: it is not shown.
    int index_of(const Row& row) const;
    /// Null: it is gone.
    const session::Message* message_of(const Row& row) const;
    static QString name_of(const session::Message& message);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    void fill();
    void forget_oldest();
    bool is_told_here(const session::Message& earlier) const;
    QString text_of(const session::Message& message, int column) const;
    QVariant look_of(const session::Message& message, int column, int role) const;

    const WindowContext& context_;
    const Tokens* tokens_ = nullptr;
    MessageFilter filter_;
    std::vector<Row> rows_;
    std::uint64_t shown_count_ = 0;
    std::size_t shown_earlier_ = 0;
};

}  // namespace psicarve::ui
