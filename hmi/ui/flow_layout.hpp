// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLayout>

#include <vector>

namespace psicarve::ui {

/// A row that goes on in the next line where a window is narrow: no wider than its widest item has to be.
class FlowLayout : public QLayout {
public:
    explicit FlowLayout(QWidget* parent = nullptr);
    ~FlowLayout() override;
    Q_DISABLE_COPY_MOVE(FlowLayout)

    /// What is added from here on stands at the right end of its line.
    void add_end() { end_from_ = items_.size(); }

    void addItem(QLayoutItem* item) override;
    int count() const override;
    QLayoutItem* itemAt(int index) const override;
    QLayoutItem* takeAt(int index) override;
    Qt::Orientations expandingDirections() const override;
    bool hasHeightForWidth() const override;
    int heightForWidth(int width) const override;
    void setGeometry(const QRect& room) override;
    QSize sizeHint() const override;
    QSize minimumSize() const override;

private:
    struct Line {
        std::size_t begin;
        std::size_t end;  ///< behind the last
        int width;
        int height;
    };

    std::vector<std::size_t> visible() const;
    std::vector<Line> lines(const std::vector<std::size_t>& shown, int width) const;

    std::vector<QLayoutItem*> items_;
    std::size_t end_from_ = static_cast<std::size_t>(-1);
};

}  // namespace psicarve::ui
