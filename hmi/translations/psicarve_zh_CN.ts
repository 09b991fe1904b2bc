<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
    <context>
        <name>psicarve</name>
        <message>
            <source> of %1</source>
            <translation> / %1</translation>
        </message>
        <message>
            <source> or </source>
            <translation> 或 </translation>
        </message>
        <message>
            <source>! CORE LATE</source>
            <translation>! 内核迟滞</translation>
        </message>
        <message>
            <source>! LIMIT</source>
            <translation>! 限位</translation>
        </message>
        <message>
            <source>% stands among other things, or in the middle</source>
            <translation>% 与其他内容混在一起，或位于程序中间</translation>
        </message>
        <message>
            <source>%1 % of the surface</source>
            <translation>表面的 %1 %</translation>
        </message>
        <message>
            <source>%1 MB, %2 faces</source>
            <translation>%1 MB，%2 个面</translation>
        </message>
        <message>
            <source>%1 alone finds its home position</source>
            <translation>%1 单独回零</translation>
        </message>
        <message>
            <source>%1 and %2 are both on output pin %3; give one of them another pin (only enables may share)</source>
            <translation>%1 与 %2 都在输出引脚 %3；请给其中一个另一引脚（只有使能信号可以共用）</translation>
        </message>
        <message>
            <source>%1 and %2 both use axis words</source>
            <translation>%1 和 %2 都使用轴字</translation>
        </message>
        <message>
            <source>%1 and %2 share pin %3, one active high and one active low; give both the same sign</source>
            <translation>%1 与 %2 共用引脚 %3，一个高有效、一个低有效；请给两者相同的符号</translation>
        </message>
        <message>
            <source>%1 and %2 share pin %3: what homing looks for would be an emergency stop; give one of them another pin, or 0</source>
            <translation>%1 与 %2 共用引脚 %3：回零所寻找的信号就成了急停；请给其中一个另一引脚，或设为 0</translation>
        </message>
        <message>
            <source>%1 and %2: %3 differences</source>
            <translation>%1 与 %2：%3 处不同</translation>
        </message>
        <message>
            <source>%1 and %2: nothing differs</source>
            <translation>%1 与 %2：没有不同</translation>
        </message>
        <message>
            <source>%1 behind else</source>
            <translation>else 之后出现 %1</translation>
        </message>
        <message>
            <source>%1 blocks in loops make no move, no dwell and no stop</source>
            <translation>循环中的 %1 个程序段没有运动、停留或停止</translation>
        </message>
        <message>
            <source>%1 can only be read</source>
            <translation>%1 只能读取</translation>
        </message>
        <message>
            <source>%1 cannot count so far</source>
            <translation>%1 无法计数到那么远</translation>
        </message>
        <message>
            <source>%1 cannot stand at %2 mm; its travel is %3 to %4 mm</source>
            <translation>%1 不可能在 %2 mm；其行程为 %3 至 %4 mm</translation>
        </message>
        <message>
            <source>%1 carries several jobs; it is shown with the first</source>
            <translation>%1 内含多个作业；按第一个显示</translation>
        </message>
        <message>
            <source>%1 cells</source>
            <translation>%1 个单元</translation>
        </message>
        <message>
            <source>%1 changes</source>
            <translation>%1 次变化</translation>
        </message>
        <message>
            <source>%1 changes not saved</source>
            <translation>%1 处修改未保存</translation>
        </message>
        <message>
            <source>%1 closed</source>
            <translation>%1 已闭合</translation>
        </message>
        <message>
            <source>%1 cm³</source>
            <translation>%1 cm³</translation>
        </message>
        <message>
            <source>%1 comes to %2 mm, and the core that it must not reach ends at %3 mm</source>
            <translation>%1 到达 %2 mm，而不得进入的芯部止于 %3 mm</translation>
        </message>
        <message>
            <source>%1 comes to %2 mm, its travel is %3 mm to %4 mm</source>
            <translation>%1 到达 %2 mm，其行程为 %3 mm 至 %4 mm</translation>
        </message>
        <message>
            <source>%1 dir</source>
            <translation>%1 方向</translation>
        </message>
        <message>
            <source>%1 en</source>
            <translation>%1 使能</translation>
        </message>
        <message>
            <source>%1 ended: %2</source>
            <translation>%1 结束：%2</translation>
        </message>
        <message>
            <source>%1 entries</source>
            <translation>%1 条记录</translation>
        </message>
        <message>
            <source>%1 faces</source>
            <translation>%1 个面</translation>
        </message>
        <message>
            <source>%1 facets</source>
            <translation>%1 个面</translation>
        </message>
        <message>
            <source>%1 facets, %2 cm³</source>
            <translation>%1 个面，%2 cm³</translation>
        </message>
        <message>
            <source>%1 found its sensor</source>
            <translation>%1 找到传感器</translation>
        </message>
        <message>
            <source>%1 free in /dev/shm</source>
            <translation>/dev/shm 中空闲 %1</translation>
        </message>
        <message>
            <source>%1 goes at %2 at most, and so it does</source>
            <translation>%1 最多以 %2 运行，现按此速度运行</translation>
        </message>
        <message>
            <source>%1 has a value of more than 1000000000</source>
            <translation>%1 的值大于 1000000000</translation>
        </message>
        <message>
            <source>%1 has no %2, the depth</source>
            <translation>%1 没有深度 %2</translation>
        </message>
        <message>
            <source>%1 has no P, the dwell</source>
            <translation>%1 没有停留时间 P</translation>
        </message>
        <message>
            <source>%1 has no P, the number</source>
            <translation>%1 没有编号 P</translation>
        </message>
        <message>
            <source>%1 has no Q, the depth of a peck</source>
            <translation>%1 没有每次啄钻深度 Q</translation>
        </message>
        <message>
            <source>%1 has no R</source>
            <translation>%1 没有 R</translation>
        </message>
        <message>
            <source>%1 has no axis word</source>
            <translation>%1 没有轴字</translation>
        </message>
        <message>
            <source>%1 has no closed outline: its lines are engraved</source>
            <translation>%1 没有闭合轮廓：改为雕刻其线条</translation>
        </message>
        <message>
            <source>%1 has no number</source>
            <translation>%1 后没有数字</translation>
        </message>
        <message>
            <source>%1 has no value</source>
            <translation>%1 没有值</translation>
        </message>
        <message>
            <source>%1 has no value in [ ]</source>
            <translation>%1 没有 [ ] 中的值</translation>
        </message>
        <message>
            <source>%1 has no way left in this direction</source>
            <translation>%1 在此方向已无行程</translation>
        </message>
        <message>
            <source>%1 in a system that is rotated</source>
            <translation>在旋转的坐标系中使用 %1</translation>
        </message>
        <message>
            <source>%1 in use</source>
            <translation>%1 个在用</translation>
        </message>
        <message>
            <source>%1 is above the axis' top speed of %2; lower it, or raise %3</source>
            <translation>%1 高于该轴最高速度 %2；请降低，或提高 %3</translation>
        </message>
        <message>
            <source>%1 is half a revolution of %2 pulses or more, so lost steps would never be noticed; lower it</source>
            <translation>%1 达到 %2 脉冲的半转或更多，丢步将永远不会被发现；请减小</translation>
        </message>
        <message>
            <source>%1 is impossible; give a value from %2 to %3</source>
            <translation>%1 不允许；请输入 %2 到 %3</translation>
        </message>
        <message>
            <source>%1 is less than 0</source>
            <translation>%1 小于 0</translation>
        </message>
        <message>
            <source>%1 is no group code</source>
            <translation>%1 不是组码</translation>
        </message>
        <message>
            <source>%1 is no head of a table: y_mm,r_mm or y_pulses,r_pulses, or what snapshot export writes</source>
            <translation>%1 不是表格的表头：应为 y_mm,r_mm 或 y_pulses,r_pulses，或 snapshot export 所写的表头</translation>
        </message>
        <message>
            <source>%1 is no number to work with; give a finite one</source>
            <translation>%1 不是可用的数字；请输入有限的数</translation>
        </message>
        <message>
            <source>%1 is no whole number</source>
            <translation>%1 不是整数</translation>
        </message>
        <message>
            <source>%1 is no word of an arc in %2</source>
            <translation>%1 不是 %2 平面圆弧的字</translation>
        </message>
        <message>
            <source>%1 is not a number</source>
            <translation>%1 不是数字</translation>
        </message>
        <message>
            <source>%1 is not a number that a table can hold</source>
            <translation>%1 不是表格可用的数</translation>
        </message>
        <message>
            <source>%1 is not a number: a vertex needs three</source>
            <translation>%1 不是数字：一个顶点需要三个数字</translation>
        </message>
        <message>
            <source>%1 is not a whole number</source>
            <translation>%1 不是整数</translation>
        </message>
        <message>
            <source>%1 is not a word of ASCII STL</source>
            <translation>%1 不是 ASCII STL 的关键字</translation>
        </message>
        <message>
            <source>%1 is not known</source>
            <translation>%1 未知</translation>
        </message>
        <message>
            <source>%1 is not possible here; give %2</source>
            <translation>%1 在此不允许；请输入 %2</translation>
        </message>
        <message>
            <source>%1 is not the number of a vertex</source>
            <translation>%1 不是顶点编号</translation>
        </message>
        <message>
            <source>%1 is not there</source>
            <translation>没有 %1</translation>
        </message>
        <message>
            <source>%1 is not this trace's job: the heads were elsewhere at %2 of %3 places that were looked at</source>
            <translation>%1 不是此记录的作业：查看的 %3 处中有 %2 处刀头位置不同</translation>
        </message>
        <message>
            <source>%1 is not wired to any pin</source>
            <translation>%1 未接到任何引脚</translation>
        </message>
        <message>
            <source>%1 is odd, so half a revolution is no whole number of pulses; give an even number</source>
            <translation>%1 是奇数，半转就不是整数个脉冲；请输入偶数</translation>
        </message>
        <message>
            <source>%1 is run.</source>
            <translation>%1 已运行完毕。</translation>
        </message>
        <message>
            <source>%1 layers</source>
            <translation>%1 层</translation>
        </message>
        <message>
            <source>%1 layers can be wrong, from layer %2 on%3</source>
            <translation>有 %1 层可能有误，从第 %2 层起%3</translation>
        </message>
        <message>
            <source>%1 layers, not %2: %3 is only %4 mm high, and a layer needs a pulse of axis Y</source>
            <translation>%1 层而不是 %2 层：%3 只有 %4 mm 高，每层至少需要 Y 轴一个脉冲</translation>
        </message>
        <message>
            <source>%1 left</source>
            <translation>剩余 %1</translation>
        </message>
        <message>
            <source>%1 lies beside this trace, but is of another run: it is not used</source>
            <translation>%1 与此记录放在一起，但属于另一次运行：未使用</translation>
        </message>
        <message>
            <source>%1 limit</source>
            <translation>%1 限位</translation>
        </message>
        <message>
            <source>%1 limit switch: closed</source>
            <translation>%1 限位开关：闭合</translation>
        </message>
        <message>
            <source>%1 limit switch: not known</source>
            <translation>%1 限位开关：未知</translation>
        </message>
        <message>
            <source>%1 limit switch: open</source>
            <translation>%1 限位开关：断开</translation>
        </message>
        <message>
            <source>%1 may not be written</source>
            <translation>%1 不可写</translation>
        </message>
        <message>
            <source>%1 missed</source>
            <translation>丢失 %1</translation>
        </message>
        <message>
            <source>%1 mm</source>
            <translation>%1 mm</translation>
        </message>
        <message>
            <source>%1 mm as the max sensor's edge leaves nothing of the travel of %2 to %3 mm; put it at the travel's upper end, or correct %4</source>
            <translation>%1 mm 作为 max 传感器的边沿，行程 %2 到 %3 mm 就没有剩余；请放到行程上端，或改正 %4</translation>
        </message>
        <message>
            <source>%1 mm as the min sensor's edge leaves nothing of the travel of %2 to %3 mm; put it at the travel's lower end, or correct %4</source>
            <translation>%1 mm 作为 min 传感器的边沿，行程 %2 到 %3 mm 就没有剩余；请放到行程下端，或改正 %4</translation>
        </message>
        <message>
            <source>%1 mm beside</source>
            <translation>偏 %1 mm</translation>
        </message>
        <message>
            <source>%1 mm deep goes to the middle of a cylinder of %2 mm diameter</source>
            <translation>深度 %1 mm 已到达直径 %2 mm 圆柱的中心</translation>
        </message>
        <message>
            <source>%1 mm is more than the tips are apart with both heads out, %2 mm; lower it</source>
            <translation>%1 mm 大于两个刀头都退到最外时刀尖的间距 %2 mm；请减小</translation>
        </message>
        <message>
            <source>%1 mm is more than the tool is wide, %2 mm; set it lower, or to 0</source>
            <translation>%1 mm 大于刀具宽度 %2 mm；请减小，或设为 0</translation>
        </message>
        <message>
            <source>%1 mm is out of the reach of head %2; lower it, or widen %3</source>
            <translation>%1 mm 超出刀头 %2 的可及范围；请减小，或加大 %3</translation>
        </message>
        <message>
            <source>%1 mm lies outside the travel of %2 to %3 mm by more than the %4 mm of overtravel; give a position that the axis can reach</source>
            <translation>%1 mm 超出行程 %2 到 %3 mm，且超过超程 %4 mm；请给出该轴能到达的位置</translation>
        </message>
        <message>
            <source>%1 mm, r ≤ %2</source>
            <translation>%1 mm，r ≤ %2</translation>
        </message>
        <message>
            <source>%1 mm/s</source>
            <translation>%1 mm/s</translation>
        </message>
        <message>
            <source>%1 more</source>
            <translation>另有 %1 项</translation>
        </message>
        <message>
            <source>%1 more came too fast to be written down</source>
            <translation>另有 %1 条来得太快，未能记录</translation>
        </message>
        <message>
            <source>%1 ms</source>
            <translation>%1 ms</translation>
        </message>
        <message>
            <source>%1 numbers, not %2</source>
            <translation>有 %1 个数，应为 %2 个</translation>
        </message>
        <message>
            <source>%1 of %2</source>
            <translation>%1 / %2</translation>
        </message>
        <message>
            <source>%1 of %2 facets have no finite coordinates; this is not a usable mesh</source>
            <translation>%2 个面中有 %1 个坐标不是有限数；此网格不可用</translation>
        </message>
        <message>
            <source>%1 of %2 has no end</source>
            <translation>%2 的 %1 没有结尾</translation>
        </message>
        <message>
            <source>%1 of %2 layers do not contain the axis.</source>
            <translation>%2 层中有 %1 层不包含轴心。</translation>
        </message>
        <message>
            <source>%1 of %2 layers do not contain the axis. Axis at: least lost looks for an axis that loses less.</source>
            <translation>%2 层中有 %1 层不包含轴心。“轴心位于”选“损失最少”，可寻找损失更少的轴心。</translation>
        </message>
        <message>
            <source>%1 of %2 layers do not contain the axis. With Axis at: least lost, %3 of the surface and %4 of the layers would be lost; by the same look this axis loses %5 and %6.</source>
            <translation>%2 层中有 %1 层不包含轴心。若“轴心位于”选“损失最少”，将损失 %3 的表面和 %4 的层；按同样的估算，当前轴心损失 %5 和 %6。</translation>
        </message>
        <message>
            <source>%1 of %2 pass</source>
            <translation>%2 项中 %1 项通过</translation>
        </message>
        <message>
            <source>%1 of %2 pass, %3 to look at</source>
            <translation>%2 项通过 %1，留意 %3</translation>
        </message>
        <message>
            <source>%1 of %2 s, %3 missed, at most %4 late</source>
            <translation>%1 / %2 s，错过 %3，最多迟 %4</translation>
        </message>
        <message>
            <source>%1 of %2 strokes are narrower than the tool cuts, %3 mm: they become as wide as that.</source>
            <translation>%2 条线中有 %1 条比刀具切宽 %3 mm 窄：按刀具宽度雕刻。</translation>
        </message>
        <message>
            <source>%1 of %2 within %3 of %4</source>
            <translation>%2 的 %1 位于 %4 的 %3 之内</translation>
        </message>
        <message>
            <source>%1 of %2, %3°</source>
            <translation>%1 / %2，%3°</translation>
        </message>
        <message>
            <source>%1 of %2: %3</source>
            <translation>第 %1 步，共 %2 步：%3</translation>
        </message>
        <message>
            <source>%1 of the points stand at the core radius of %2 mm: what lies inside it is not carved; a larger model or a smaller core_radius_mm loses less.</source>
            <translation>%1 的点位于芯半径 %2 mm 处：芯半径以内的部分不会雕刻；把模型放大或减小 core_radius_mm，损失会更少。</translation>
        </message>
        <message>
            <source>%1 of the points stand at the radius of %2 mm at which the heads' travel ends: what lies inside it is not carved; a larger model or a travel_mm that goes further in loses less.</source>
            <translation>%1 的点位于刀头行程终点的半径 %2 mm 处：该半径以内的部分不会雕刻；把模型放大或让 travel_mm 更靠内，损失会更少。</translation>
        </message>
        <message>
            <source>%1 of the surface lies behind another part and cannot be reached.</source>
            <translation>%1 的表面位于其他部分之后，无法到达。</translation>
        </message>
        <message>
            <source>%1 of the surface lies behind another part and cannot be reached. Axis at: least lost looks for an axis that loses less.</source>
            <translation>%1 的表面位于其他部分之后，无法到达。“轴心位于”选“损失最少”，可寻找损失更少的轴心。</translation>
        </message>
        <message>
            <source>%1 of the surface lies behind another part and cannot be reached. With Axis at: least lost, %2 of the surface and %3 of the layers would be lost; by the same look this axis loses %4 and %5.</source>
            <translation>%1 的表面位于其他部分之后，无法到达。若“轴心位于”选“损失最少”，将损失 %2 的表面和 %3 的层；按同样的估算，当前轴心损失 %4 和 %5。</translation>
        </message>
        <message>
            <source>%1 outside the loop %2</source>
            <translation>%1 不在循环 %2 之内</translation>
        </message>
        <message>
            <source>%1 planned</source>
            <translation>计划 %1</translation>
        </message>
        <message>
            <source>%1 points a layer, not %2: half a turn of axis Ψ has no more pulses</source>
            <translation>每层 %1 点而不是 %2 点：Ψ 轴半圈没有更多脉冲</translation>
        </message>
        <message>
            <source>%1 points in a layer of %2 pulses of Ψ; slice with at most %3 points</source>
            <translation>一层有 %1 个点，而 Ψ 只有 %2 个脉冲；请最多用 %3 个点切片</translation>
        </message>
        <message>
            <source>%1 pulses</source>
            <translation>%1 脉冲</translation>
        </message>
        <message>
            <source>%1 pulses counted; the simulated machine stands at %2</source>
            <translation>已计 %1 个脉冲；仿真机床位于 %2</translation>
        </message>
        <message>
            <source>%1 pulses, of what was carved</source>
            <translation>%1 脉冲（已雕刻的部分）</translation>
        </message>
        <message>
            <source>%1 radii, but the layers before have %2</source>
            <translation>有 %1 个半径，而前面各层有 %2 个</translation>
        </message>
        <message>
            <source>%1 records could not be written into the journal</source>
            <translation>%1 条记录未能写入日志</translation>
        </message>
        <message>
            <source>%1 roughing, finishing</source>
            <translation>粗加工 %1 遍，精加工</translation>
        </message>
        <message>
            <source>%1 runs, of another process. %2</source>
            <translation>另一进程的 %1 正在运行。%2</translation>
        </message>
        <message>
            <source>%1 runs. %2</source>
            <translation>%1 正在运行。%2</translation>
        </message>
        <message>
            <source>%1 since layer %2, when this window came</source>
            <translation>%1（自第 %2 层、本窗口打开时起）</translation>
        </message>
        <message>
            <source>%1 stands beside %2</source>
            <translation>%1 与 %2 同段</translation>
        </message>
        <message>
            <source>%1 stands beside %2 of its group</source>
            <translation>%1 与同组的 %2 同段</translation>
        </message>
        <message>
            <source>%1 stands twice in the block</source>
            <translation>%1 在程序段中出现两次</translation>
        </message>
        <message>
            <source>%1 step</source>
            <translation>%1 步进</translation>
        </message>
        <message>
            <source>%1 strokes are not closed and left out, the first from %2 to %3 mm.</source>
            <translation>%1 条线未闭合，已略去；第一条从 %2 到 %3 mm。</translation>
        </message>
        <message>
            <source>%1 takes no more values</source>
            <translation>%1 不接受更多的值</translation>
        </message>
        <message>
            <source>%1 tells of another piece: see which of them is mounted.</source>
            <translation>%1 记录的是另一个工件：请看安装的是哪一个。</translation>
        </message>
        <message>
            <source>%1 tells of what this machine does not have</source>
            <translation>%1 涉及本机床没有的功能</translation>
        </message>
        <message>
            <source>%1 ticks missed</source>
            <translation>漏掉 %1 个节拍</translation>
        </message>
        <message>
            <source>%1 ticks missed in the last second</source>
            <translation>最近一秒丢失 %1 个节拍</translation>
        </message>
        <message>
            <source>%1 ticks missed, %2 since the core started</source>
            <translation>丢失 %1 个节拍，内核启动以来共 %2 个</translation>
        </message>
        <message>
            <source>%1 to %2 bytes</source>
            <translation>%1 至 %2 字节</translation>
        </message>
        <message>
            <source>%1 to %2 mm</source>
            <translation>%1 至 %2 mm</translation>
        </message>
        <message>
            <source>%1 turns</source>
            <translation>%1 圈</translation>
        </message>
        <message>
            <source>%1 us are too short for a pulse and its gap, which take %2 us in ticks; lengthen it, or shorten tick.period_us</source>
            <translation>%1 us 容不下一个脉冲及其间隔，它们按节拍需 %2 us；请加长，或缩短 tick.period_us</translation>
        </message>
        <message>
            <source>%1 us is longer than the %2 us from pulse to pulse; shorten it, or lengthen tick.io_us</source>
            <translation>%1 us 长于脉冲之间的 %2 us；请缩短，或加长 tick.io_us</translation>
        </message>
        <message>
            <source>%1 us is no whole number of periods of %2 us; give a multiple of tick.period_us</source>
            <translation>%1 us 不是 %2 us 周期的整数倍；请输入 tick.period_us 的倍数</translation>
        </message>
        <message>
            <source>%1 was not opened</source>
            <translation>未能打开 %1</translation>
        </message>
        <message>
            <source>%1 was written since it was opened: Reload takes it as it is now</source>
            <translation>%1 在打开后被改写：点“重新载入”读取现在的内容</translation>
        </message>
        <message>
            <source>%1 where %2 is expected; correct the value</source>
            <translation>此处应为%2，却是%1；请改正</translation>
        </message>
        <message>
            <source>%1 where the table [%2] is expected; put its keys below [%3]</source>
            <translation>此处应为表 [%2]，却是%1；请把它的键写在 [%3] 之下</translation>
        </message>
        <message>
            <source>%1 while %2 holds</source>
            <translation>%2 有效时使用 %1</translation>
        </message>
        <message>
            <source>%1 while a cycle holds</source>
            <translation>固定循环有效时使用 %1</translation>
        </message>
        <message>
            <source>%1 without %2 before it</source>
            <translation>%1 之前没有 %2</translation>
        </message>
        <message>
            <source>%1 would bring the tips closer than head_clearance_mm, %2</source>
            <translation>%1 会使两刀尖距离小于 head_clearance_mm（%2）</translation>
        </message>
        <message>
            <source>%1 would go inside the core radius, %2</source>
            <translation>%1 会进入芯半径 %2 之内</translation>
        </message>
        <message>
            <source>%1 would leave its travel, %2 to %3</source>
            <translation>%1 会超出行程 %2 至 %3</translation>
        </message>
        <message>
            <source>%1 would take the feed's override from the operator</source>
            <translation>%1 会取消操作员的进给倍率</translation>
        </message>
        <message>
            <source>%1 · ends %2</source>
            <translation>%1 · %2 结束</translation>
        </message>
        <message>
            <source>%1 · ends about %2</source>
            <translation>%1 · 约 %2 结束</translation>
        </message>
        <message>
            <source>%1 × %2 × %3 mm, scale %4</source>
            <translation>%1 × %2 × %3 mm，比例 %4</translation>
        </message>
        <message>
            <source>%1, %2 bytes</source>
            <translation>%1，%2 字节</translation>
        </message>
        <message>
            <source>%1, PREEMPT_RT</source>
            <translation>%1，PREEMPT_RT</translation>
        </message>
        <message>
            <source>%1, checked</source>
            <translation>%1，已核对</translation>
        </message>
        <message>
            <source>%1, facets: %2</source>
            <translation>%1，面数：%2</translation>
        </message>
        <message>
            <source>%1, held against %2</source>
            <translation>%1，对照 %2</translation>
        </message>
        <message>
            <source>%1, not %2 of --profile</source>
            <translation>%1，而非 --profile 的 %2</translation>
        </message>
        <message>
            <source>%1, not PREEMPT_RT</source>
            <translation>%1，非 PREEMPT_RT</translation>
        </message>
        <message>
            <source>%1, not checked</source>
            <translation>%1，未核对</translation>
        </message>
        <message>
            <source>%1, not finished</source>
            <translation>%1，未完成</translation>
        </message>
        <message>
            <source>%1, of another run</source>
            <translation>%1，属于另一次运行</translation>
        </message>
        <message>
            <source>%1. Lose them?</source>
            <translation>%1。要放弃吗？</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1：%2</translation>
        </message>
        <message>
            <source>%1: %2 to look at</source>
            <translation>%1：有 %2 条需要查看</translation>
        </message>
        <message>
            <source>%1: %2 values become others</source>
            <translation>%1：%2 个值将改变</translation>
        </message>
        <message>
            <source>%1: %2; %3</source>
            <translation>%1：%2；%3</translation>
        </message>
        <message>
            <source>%1: core %2, here %3</source>
            <translation>%1：内核 %2，此处 %3</translation>
        </message>
        <message>
            <source>%1: cutter compensation is not done</source>
            <translation>%1：不支持刀具补偿</translation>
        </message>
        <message>
            <source>%1: homed</source>
            <translation>%1：已回零</translation>
        </message>
        <message>
            <source>%1: it would not say what is shown here; open it again</source>
            <translation>%1：文件写出后与此处所示不符；请重新打开</translation>
        </message>
        <message>
            <source>%1: its flight recorder tells of another run; its entries are not shown</source>
            <translation>%1：其运行记录属于另一次运行；不显示其条目</translation>
        </message>
        <message>
            <source>%1: line %2: %3 cannot be set as this is written; give its table a header, [%4], and each key a line below it</source>
            <translation>%1：第 %2 行：按现在的写法无法设置 %3；请给它的表写表头 [%4]，每个键在其下各占一行</translation>
        </message>
        <message>
            <source>%1: line %2: %3 has no place: a table of that name stands here; rename it</source>
            <translation>%1：第 %2 行：%3 没有位置：此处有同名的表；请改名</translation>
        </message>
        <message>
            <source>%1: line %2: %3 has no place: a value of that name stands here; rename it</source>
            <translation>%1：第 %2 行：%3 没有位置：此处有同名的值；请改名</translation>
        </message>
        <message>
            <source>%1: not found beside psicarve-hmi nor in PATH; install it there</source>
            <translation>%1：在 psicarve-hmi 旁边和 PATH 中都找不到；请安装到那里</translation>
        </message>
        <message>
            <source>%1: not homed</source>
            <translation>%1：未回零</translation>
        </message>
        <message>
            <source>%1: one value becomes another</source>
            <translation>%1：1 个值将改变</translation>
        </message>
        <message>
            <source>%1: somebody has changed this file since it was opened; save under another name, or open it again and lose these changes</source>
            <translation>%1：该文件打开后已被他人修改；请另存为其他名称，或重新打开并放弃这些修改</translation>
        </message>
        <message>
            <source>%1: the machine has no input for it</source>
            <translation>%1：机床没有对应的输入</translation>
        </message>
        <message>
            <source>%1: the machine has no such output or input</source>
            <translation>%1：机床没有这样的输出或输入</translation>
        </message>
        <message>
            <source>%1: there is no tool table</source>
            <translation>%1：没有刀具表</translation>
        </message>
        <message>
            <source>%1: whether it is homed is not known</source>
            <translation>%1：是否已回零未知</translation>
        </message>
        <message>
            <source>%1: whether it was homed is not recorded</source>
            <translation>%1：是否回零未记录</translation>
        </message>
        <message>
            <source>%1: work offsets cannot be kept: %2</source>
            <translation>%1：无法保存工件偏置：%2</translation>
        </message>
        <message>
            <source>%1–%2 mm high (%3 %)</source>
            <translation>高 %1–%2 mm（%3 %）</translation>
        </message>
        <message>
            <source>%1–%2°, through 0° (%3 %)</source>
            <translation>%1–%2°，经过 0°（%3 %）</translation>
        </message>
        <message>
            <source>%2 (%1 times, here first)</source>
            <translation>%2（共 %1 次，此处为第一次）</translation>
        </message>
        <message>
            <source>%2 (line %1 of the program)</source>
            <translation>%2（程序第 %1 行）</translation>
        </message>
        <message>
            <source>%2 · override %1 %</source>
            <translation>%2 · 倍率 %1 %</translation>
        </message>
        <message>
            <source>%3 (layer %1, point %2)</source>
            <translation>%3（第 %1 层，第 %2 点）</translation>
        </message>
        <message>
            <source>%3 where the table [%1] is expected; put its keys below [%2]</source>
            <translation>此处应为表 [%1]，却是%3；请把它的键写在 [%2] 之下</translation>
        </message>
        <message>
            <source>'%1' begins no word</source>
            <translation>“%1”不能作为字的开头</translation>
        </message>
        <message>
            <source>'%1' is neither an operator nor ]</source>
            <translation>“%1”既不是运算符也不是 ]</translation>
        </message>
        <message>
            <source>'%1...' is more than 1000000000</source>
            <translation>“%1...”大于 1000000000</translation>
        </message>
        <message>
            <source>(told of line %1)</source>
            <translation>（第 %1 行时的数据）</translation>
        </message>
        <message>
            <source>--port io:ADDRESS is refused</source>
            <translation>--port io:ADDRESS 会被拒绝</translation>
        </message>
        <message>
            <source>0 ms</source>
            <translation>0 ms</translation>
        </message>
        <message>
            <source>1 % later than %1</source>
            <translation>1 % 晚于 %1</translation>
        </message>
        <message>
            <source>1 change not saved</source>
            <translation>1 处修改未保存</translation>
        </message>
        <message>
            <source>1 stroke is not closed and left out, from %1 to %2 mm.</source>
            <translation>1 条线未闭合，已略去：从 %1 到 %2 mm。</translation>
        </message>
        <message>
            <source>1 to 10000 pulses, 1 to 500 in a second</source>
            <translation>1 到 10000 个脉冲，每秒 1 到 500 个</translation>
        </message>
        <message>
            <source>1 turn</source>
            <translation>1 圈</translation>
        </message>
        <message>
            <source>10 to 100 per cent of the speed of rapid ways, whole</source>
            <translation>快速移动速度的 10 至 100 %，整数</translation>
        </message>
        <message>
            <source>10 to 200 per cent of the planned feed, whole</source>
            <translation>计划进给的 10 到 200 %，整数</translation>
        </message>
        <message>
            <source>100 blocks within each other</source>
            <translation>嵌套 100 层程序块</translation>
        </message>
        <message>
            <source>100 calls within each other</source>
            <translation>嵌套 100 层调用</translation>
        </message>
        <message>
            <source>3 of 3</source>
            <translation>3/3</translation>
        </message>
        <message>
            <source>99 % of the ticks were no later; page Real time tells more</source>
            <translation>99 % 的节拍不比这更迟；详见实时页</translation>
        </message>
        <message>
            <source>&lt; has no &gt;</source>
            <translation>&lt; 没有对应的 &gt;</translation>
        </message>
        <message>
            <source>&lt; is missing</source>
            <translation>缺少 &lt;</translation>
        </message>
        <message>
            <source>&lt;%1&gt; is left out.</source>
            <translation>&lt;%1&gt; 已略去。</translation>
        </message>
        <message>
            <source>&lt;%1&gt; is not right and left out.</source>
            <translation>&lt;%1&gt; 有误，已略去。</translation>
        </message>
        <message>
            <source>&lt;%1&gt; is not right; what follows the fault is left out.</source>
            <translation>&lt;%1&gt; 有误；错误之后的内容已略去。</translation>
        </message>
        <message>
            <source>&lt;switch&gt; holds nothing for every language and is left out.</source>
            <translation>&lt;switch&gt; 中没有适用于所有语言的内容，已略去。</translation>
        </message>
        <message>
            <source>&lt;use&gt; of something that is not in this file is left out.</source>
            <translation>&lt;use&gt; 引用的内容不在此文件中，已略去。</translation>
        </message>
        <message>
            <source>? index</source>
            <translation>? 零位</translation>
        </message>
        <message>
            <source>? limit</source>
            <translation>? 限位</translation>
        </message>
        <message>
            <source>A draft of what the tool will leave, before the model is sliced</source>
            <translation>刀具会留下什么的草图，在模型切片之前</translation>
        </message>
        <message>
            <source>A head moving in to its first point.</source>
            <translation>刀头进给到第一点的速度。</translation>
        </message>
        <message>
            <source>A job is being made; cancel it first</source>
            <translation>正在生成作业；请先取消</translation>
        </message>
        <message>
            <source>A message that is selected above stands here in full.</source>
            <translation>上方选中的消息在此完整显示。</translation>
        </message>
        <message>
            <source>A new blank has to begin with layer 1.</source>
            <translation>新毛坯必须从第 1 层开始。</translation>
        </message>
        <message>
            <source>A part of layer 1 of %1 is carved and would be carved again.</source>
            <translation>%1 层中的第 1 层已雕刻一部分，将重新雕刻。</translation>
        </message>
        <message>
            <source>A program of another process runs. %1</source>
            <translation>另一进程的程序正在运行。%1</translation>
        </message>
        <message>
            <source>A program that runs keeps what it was started with</source>
            <translation>运行中的程序保持启动时的选择</translation>
        </message>
        <message>
            <source>A recording is being opened</source>
            <translation>正在打开记录</translation>
        </message>
        <message>
            <source>A sensor counts once it has stood this long; the emergency stop is never filtered.</source>
            <translation>传感器信号保持这么久才算数；急停从不滤波。</translation>
        </message>
        <message>
            <source>A step pulse ends at a later tick, or after a wait inside its own: one pulse a tick.</source>
            <translation>步进脉冲在后一个节拍结束，或在本节拍内等待后结束：每个节拍一个脉冲。</translation>
        </message>
        <message>
            <source>A step pulse lasts at least this long.</source>
            <translation>步进脉冲至少持续这么久。</translation>
        </message>
        <message>
            <source>A stream</source>
            <translation>数据流</translation>
        </message>
        <message>
            <source>A table's layers and radii are taken as they stand</source>
            <translation>表格的层和半径按原样采用</translation>
        </message>
        <message>
            <source>A tool becomes shorter as it wears: a piece that comes out thicker on the half of %1 by so much in radius. It is counted from the head's touch-off.</source>
            <translation>刀具磨损后变短：工件在 %1 的一半半径会大出这么多。自该刀头对刀时算起。</translation>
        </message>
        <message>
            <source>A typed block</source>
            <translation>输入的程序段</translation>
        </message>
        <message>
            <source>A window ended before it was published or saved. Nothing is published, nothing moves.</source>
            <translation>窗口在其发布或保存之前结束。不会发布，也不会运动。</translation>
        </message>
        <message>
            <source>ACOS of a value beyond 1</source>
            <translation>ACOS 的自变量绝对值大于 1</translation>
        </message>
        <message>
            <source>ALARM</source>
            <translation>报警</translation>
        </message>
        <message>
            <source>ASIN of a value beyond 1</source>
            <translation>ASIN 的自变量绝对值大于 1</translation>
        </message>
        <message>
            <source>ATAN takes two values: ATAN[y]/[x]</source>
            <translation>ATAN 需要两个值：ATAN[y]/[x]</translation>
        </message>
        <message>
            <source>About Psicarve</source>
            <translation>关于 Psicarve</translation>
        </message>
        <message>
            <source>About Psicarve…</source>
            <translation>关于 Psicarve…</translation>
        </message>
        <message>
            <source>Above the blank's top there is nothing to cut: %1 of %2 layers are left out.</source>
            <translation>毛坯顶面以上无可切削：%2 层中略去 %1 层。</translation>
        </message>
        <message>
            <source>Acceleration that the motor follows (a_k).</source>
            <translation>电机能跟上的加速度（a_k）。</translation>
        </message>
        <message>
            <source>Acknowledge</source>
            <translation>确认</translation>
        </message>
        <message>
            <source>Active low</source>
            <translation>低电平有效</translation>
        </message>
        <message>
            <source>Add its job…</source>
            <translation>添加作业…</translation>
        </message>
        <message>
            <source>Alarm</source>
            <translation>报警</translation>
        </message>
        <message>
            <source>Alarm: %1</source>
            <translation>报警：%1</translation>
        </message>
        <message>
            <source>Alarm: %1 of %2</source>
            <translation>报警：%1，%2</translation>
        </message>
        <message>
            <source>Alarms</source>
            <translation>报警</translation>
        </message>
        <message>
            <source>All</source>
            <translation>全部</translation>
        </message>
        <message>
            <source>All chosen axes together; Ψ the short way. Stop and F1 end it.</source>
            <translation>所选各轴同时运动；Ψ 走近路。停止和 F1 可中止。</translation>
        </message>
        <message>
            <source>All files (*)</source>
            <translation>所有文件 (*)</translation>
        </message>
        <message>
            <source>All layers, unrolled</source>
            <translation>所有层的展开图</translation>
        </message>
        <message>
            <source>All round</source>
            <translation>整周</translation>
        </message>
        <message>
            <source>All runs</source>
            <translation>所有运行</translation>
        </message>
        <message>
            <source>All runs: also what the cores have written down before this window was opened, in grey</source>
            <translation>所有运行：还包括本窗口打开之前内核记录的内容，显示为灰色</translation>
        </message>
        <message>
            <source>All that can be opened (%1)</source>
            <translation>所有可打开的文件 (%1)</translation>
        </message>
        <message>
            <source>Allowance</source>
            <translation>余量</translation>
        </message>
        <message>
            <source>Angle</source>
            <translation>角度</translation>
        </message>
        <message>
            <source>Arm</source>
            <translation>启用</translation>
        </message>
        <message>
            <source>Arm keyboard jog</source>
            <translation>启用键盘点动</translation>
        </message>
        <message>
            <source>Armed for one output, all others off. Ends after 30 s, on focus loss or F1.</source>
            <translation>仅一个输出可用，其余关闭。30 秒后、失去焦点或按 F1 时结束。</translation>
        </message>
        <message>
            <source>As fast as every motor can follow, or the original's acceleration segments.</source>
            <translation>以各电机能跟上的最快速度，或采用原机的加减速段。</translation>
        </message>
        <message>
            <source>As large as the machine's travel and the blank let it be</source>
            <translation>在机床行程和毛坯允许范围内尽可能大</translation>
        </message>
        <message>
            <source>As planned, at 100 % feed: bright where the heads take long</source>
            <translation>按规划、进给 100 %：越亮表示刀头用时越长</translation>
        </message>
        <message>
            <source>As the desktop</source>
            <translation>跟随桌面</translation>
        </message>
        <message>
            <source>Asked for by %1, process %2</source>
            <translation>请求者：%1，进程 %2</translation>
        </message>
        <message>
            <source>Asked for: %1</source>
            <translation>已请求：%1</translation>
        </message>
        <message>
            <source>At the first point</source>
            <translation>在第一点</translation>
        </message>
        <message>
            <source>Axes homed</source>
            <translation>各轴已回零</translation>
        </message>
        <message>
            <source>Axis</source>
            <translation>轴</translation>
        </message>
        <message>
            <source>Axis %1 stood at %2. The pause was longer than its motor coasts: it may have lost steps.</source>
            <translation>轴 %1 位于 %2。停顿超过电机的惯性滑行时间：可能已丢步。</translation>
        </message>
        <message>
            <source>Axis %1 stopped at %2. Likely a chip or a broken wire at the switch, or lost steps.</source>
            <translation>轴 %1 停在 %2。可能是开关处有切屑或断线，或者丢步。</translation>
        </message>
        <message>
            <source>Axis %1 stopped at %2; its switch stands at %3 mm. Likely a chip or a broken wire at the switch, or %1 has lost steps.</source>
            <translation>轴 %1 停在 %2；其开关位于 %3 mm。可能是开关处有切屑或断线，或者 %1 丢步。</translation>
        </message>
        <message>
            <source>Axis R1</source>
            <translation>R1 轴</translation>
        </message>
        <message>
            <source>Axis R2</source>
            <translation>R2 轴</translation>
        </message>
        <message>
            <source>Axis Y</source>
            <translation>Y 轴</translation>
        </message>
        <message>
            <source>Axis at</source>
            <translation>轴心位于</translation>
        </message>
        <message>
            <source>Axis Ψ</source>
            <translation>Ψ 轴</translation>
        </message>
        <message>
            <source>Axis: least lost</source>
            <translation>轴心：损失最少</translation>
        </message>
        <message>
            <source>BACKING OFF</source>
            <translation>退离中</translation>
        </message>
        <message>
            <source>Back</source>
            <translation>上一步</translation>
        </message>
        <message>
            <source>Back off</source>
            <translation>退离</translation>
        </message>
        <message>
            <source>Back off: no switch is closed</source>
            <translation>退离：没有开关闭合</translation>
        </message>
        <message>
            <source>Back off: there is no alarm</source>
            <translation>退离：没有报警</translation>
        </message>
        <message>
            <source>Back the axis off its sensor, reset the alarm, then home; check the wire if no axis stands at a sensor.</source>
            <translation>使轴退离传感器，复位报警，然后回零；若没有轴在传感器处，请检查接线。</translation>
        </message>
        <message>
            <source>Back to the machine</source>
            <translation>回到机床</translation>
        </message>
        <message>
            <source>Back: this is the first step</source>
            <translation>上一步：这是第一步</translation>
        </message>
        <message>
            <source>Before</source>
            <translation>原值</translation>
        </message>
        <message>
            <source>Before its first line</source>
            <translation>在第一行之前</translation>
        </message>
        <message>
            <source>Before this window was there: %1</source>
            <translation>本窗口打开之前：%1</translation>
        </message>
        <message>
            <source>Begins at</source>
            <translation>起始方向</translation>
        </message>
        <message>
            <source>Begins in %1 (zero%2) with the work offsets of %3.</source>
            <translation>从 %1 开始（零点%2），工件偏置取自 %3。</translation>
        </message>
        <message>
            <source>Begins in %1 at the machine's zero, as %2 has it.</source>
            <translation>从 %1 开始，即机床零点（依据 %2）。</translation>
        </message>
        <message>
            <source>Begins with layer 1 again; it asks first</source>
            <translation>再次从第 1 层开始；会先询问</translation>
        </message>
        <message>
            <source>Begun anew: none of %1 layers is finished</source>
            <translation>已重新开始：%1 层中没有完成的层</translation>
        </message>
        <message>
            <source>Begun anew: none of %1 layers of %2 is finished</source>
            <translation>已重新开始：“%2”的 %1 层中没有完成的层</translation>
        </message>
        <message>
            <source>Between entries</source>
            <translation>记录之间</translation>
        </message>
        <message>
            <source>Between two points of a layer the tool goes up to %1 mm too deep along its radius, into the model mostly less; more points make that less.</source>
            <translation>在一层的两点之间，刀具沿半径方向过深最多 %1 mm，切入模型通常更少；增加点数可减小。</translation>
        </message>
        <message>
            <source>Between two points the path may leave the straight line by this.</source>
            <translation>两点之间轨迹可偏离直线这么多。</translation>
        </message>
        <message>
            <source>Black and white change places</source>
            <translation>黑白互换</translation>
        </message>
        <message>
            <source>Black, white</source>
            <translation>黑、白</translation>
        </message>
        <message>
            <source>Blank</source>
            <translation>毛坯</translation>
        </message>
        <message>
            <source>Blank height</source>
            <translation>毛坯高度</translation>
        </message>
        <message>
            <source>Blank in the way?</source>
            <translation>毛坯挡路？</translation>
        </message>
        <message>
            <source>Blank matches job</source>
            <translation>毛坯与作业相符</translation>
        </message>
        <message>
            <source>Blank off, 0°</source>
            <translation>毛坯偏移，0°</translation>
        </message>
        <message>
            <source>Blank off, 90°</source>
            <translation>毛坯偏移，90°</translation>
        </message>
        <message>
            <source>Blank radius</source>
            <translation>毛坯半径</translation>
        </message>
        <message>
            <source>Block asked for: %1</source>
            <translation>已请求程序段：%1</translation>
        </message>
        <message>
            <source>Block delete</source>
            <translation>跳过程序段</translation>
        </message>
        <message>
            <source>Bodies</source>
            <translation>实体</translation>
        </message>
        <message>
            <source>Both heads go out to the end of their travel.</source>
            <translation>两个刀头退到行程末端。</translation>
        </message>
        <message>
            <source>Both heads in</source>
            <translation>两刀头向内</translation>
        </message>
        <message>
            <source>Both heads out</source>
            <translation>两刀头向外</translation>
        </message>
        <message>
            <source>Bound by</source>
            <translation>限制因素</translation>
        </message>
        <message>
            <source>Bounds</source>
            <translation>范围</translation>
        </message>
        <message>
            <source>Brightness to this power</source>
            <translation>亮度取此次幂</translation>
        </message>
        <message>
            <source>Built-in profile</source>
            <translation>内置配置</translation>
        </message>
        <message>
            <source>By feed and top speeds alone; acceleration takes longer</source>
            <translation>仅按进给和最高速度；加速需要更多时间</translation>
        </message>
        <message>
            <source>By feed and top speeds alone; it is planned while the machine is at rest</source>
            <translation>仅按进给和最高速度；机床静止时进行规划</translation>
        </message>
        <message>
            <source>By hand</source>
            <translation>手动</translation>
        </message>
        <message>
            <source>By hand; a job does it by itself, and Stop switches it off</source>
            <translation>手动；任务会自动控制，停止会关闭主轴</translation>
        </message>
        <message>
            <source>By mouse, or with Ctrl+−, Ctrl++ and Ctrl+0</source>
            <translation>用鼠标，或 Ctrl+−、Ctrl++ 和 Ctrl+0</translation>
        </message>
        <message>
            <source>CARVING</source>
            <translation>雕刻中</translation>
        </message>
        <message>
            <source>Calibrate</source>
            <translation>校准</translation>
        </message>
        <message>
            <source>Calibrate the heads</source>
            <translation>校准刀头</translation>
        </message>
        <message>
            <source>Calibrate the heads…</source>
            <translation>校准刀头…</translation>
        </message>
        <message>
            <source>Calibrate: a value of the profile is wrong</source>
            <translation>校准：配置中有一个值不正确</translation>
        </message>
        <message>
            <source>Calibrate: open the machine's profile first, or save this one as a file</source>
            <translation>校准：请先打开机床配置，或将此配置存为文件</translation>
        </message>
        <message>
            <source>Calibrate: save the profile first, or undo what was changed</source>
            <translation>校准：请先保存配置，或撤销更改</translation>
        </message>
        <message>
            <source>Calibrate…</source>
            <translation>校准…</translation>
        </message>
        <message>
            <source>Calibration written: %1; the old profile is %2</source>
            <translation>校准已写入：%1；原配置为 %2</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>取消</translation>
        </message>
        <message>
            <source>Cancel reading</source>
            <translation>取消读取</translation>
        </message>
        <message>
            <source>Cancel verification</source>
            <translation>取消校验</translation>
        </message>
        <message>
            <source>Cancel: nothing is being read</source>
            <translation>取消：没有正在读取的内容</translation>
        </message>
        <message>
            <source>Carved against wanted: blue too deep, brown material left</source>
            <translation>实际与要求之差：蓝色过深，棕色有余料</translation>
        </message>
        <message>
            <source>Carved piece</source>
            <translation>工件</translation>
        </message>
        <message>
            <source>Carves from the point where the heads wait (Ctrl+Enter)</source>
            <translation>从刀头等待的点开始雕刻（Ctrl+Enter）</translation>
        </message>
        <message>
            <source>Carves the begun layer once more from its begin</source>
            <translation>从头再雕刻一次已开始的那一层</translation>
        </message>
        <message>
            <source>Carves this layer and stops in order; press again for the next one</source>
            <translation>雕刻这一层后有序停止；再按一次雕刻下一层</translation>
        </message>
        <message>
            <source>Carving</source>
            <translation>雕刻</translation>
        </message>
        <message>
            <source>Carving began with layer %2, point %3: %1</source>
            <translation>从第 %2 层第 %3 点开始雕刻：%1</translation>
        </message>
        <message>
            <source>Carving began with layer %2: %1</source>
            <translation>从第 %2 层开始雕刻：%1</translation>
        </message>
        <message>
            <source>Carving time</source>
            <translation>雕刻时间</translation>
        </message>
        <message>
            <source>Centre of the arc</source>
            <translation>圆弧中心</translation>
        </message>
        <message>
            <source>Centre of the arc, %1</source>
            <translation>圆弧中心，%1</translation>
        </message>
        <message>
            <source>Changed</source>
            <translation>已修改</translation>
        </message>
        <message>
            <source>Changed since it was sliced: slice again to take it over.</source>
            <translation>切片之后有更改：请重新切片以采用。</translation>
        </message>
        <message>
            <source>Changes that, and slices again</source>
            <translation>改为此值并重新切片</translation>
        </message>
        <message>
            <source>Charge pump</source>
            <translation>电荷泵</translation>
        </message>
        <message>
            <source>Check the axis' home sensor, its wire and its pin in the profile; reset the alarm, then home again.</source>
            <translation>检查该轴的回零传感器、接线和配置中的引脚；复位报警，然后重新回零。</translation>
        </message>
        <message>
            <source>Check the port's card, cable and driver; once it answers again, reset the alarm, then home.</source>
            <translation>检查端口的板卡、电缆和驱动程序；端口恢复应答后，复位报警，然后回零。</translation>
        </message>
        <message>
            <source>Check the sensor of axis %1</source>
            <translation>检查轴 %1 的传感器</translation>
        </message>
        <message>
            <source>Check this computer</source>
            <translation>检查本机</translation>
        </message>
        <message>
            <source>Choose a file...</source>
            <translation>选择文件...</translation>
        </message>
        <message>
            <source>Circumference of the cylinder, mm</source>
            <translation>圆柱周长，mm</translation>
        </message>
        <message>
            <source>Clear switch %1, or Back off, until its lamp goes out</source>
            <translation>清理开关 %1，或按“退离”，直到其指示灯熄灭</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>关闭</translation>
        </message>
        <message>
            <source>Close other programs, or give the core real-time rights</source>
            <translation>关闭其他程序，或授予内核实时权限</translation>
        </message>
        <message>
            <source>Close the window</source>
            <translation>关闭窗口</translation>
        </message>
        <message>
            <source>Closed: %1, neither published nor saved</source>
            <translation>已关闭：%1，既未发布也未保存</translation>
        </message>
        <message>
            <source>Column %1: %2</source>
            <translation>第 %1 列：%2</translation>
        </message>
        <message>
            <source>Command</source>
            <translation>命令</translation>
        </message>
        <message>
            <source>Command: %1</source>
            <translation>命令：%1</translation>
        </message>
        <message>
            <source>Command: %1 (%2)</source>
            <translation>命令：%1（%2）</translation>
        </message>
        <message>
            <source>Commands</source>
            <translation>命令</translation>
        </message>
        <message>
            <source>Compare</source>
            <translation>比较</translation>
        </message>
        <message>
            <source>Compare two snapshots…</source>
            <translation>比较两个快照…</translation>
        </message>
        <message>
            <source>Compare with defaults</source>
            <translation>与默认值比较</translation>
        </message>
        <message>
            <source>Comparison</source>
            <translation>比较</translation>
        </message>
        <message>
            <source>Confirm and start</source>
            <translation>确认并启动</translation>
        </message>
        <message>
            <source>Continue from layer %1</source>
            <translation>从第 %1 层继续</translation>
        </message>
        <message>
            <source>Continue from layer %1, point %2</source>
            <translation>从第 %1 层第 %2 点继续</translation>
        </message>
        <message>
            <source>Controlled stop above this many missed ticks a second; 0: never.</source>
            <translation>每秒丢失的节拍超过此数时受控停止；0：从不。</translation>
        </message>
        <message>
            <source>Core alive</source>
            <translation>内核正常</translation>
        </message>
        <message>
            <source>Core found, process %1</source>
            <translation>找到内核，进程 %1</translation>
        </message>
        <message>
            <source>Core: profile %1, not %2</source>
            <translation>内核：配置 %1，而非 %2</translation>
        </message>
        <message>
            <source>Cutting end of the tools; jobs keep all of it out of the model. A point has no size.</source>
            <translation>刀具的切削端；加工任务使整个切削端不进入模型。point 没有尺寸。</translation>
        </message>
        <message>
            <source>DRY RUN</source>
            <translation>空运行</translation>
        </message>
        <message>
            <source>Damaged or torn records of the machine's history are left out: %1</source>
            <translation>机床历史中损坏的记录已略去：%1</translation>
        </message>
        <message>
            <source>Dark</source>
            <translation>深色</translation>
        </message>
        <message>
            <source>Decode</source>
            <translation>解析</translation>
        </message>
        <message>
            <source>Decode: no program is open</source>
            <translation>解析：没有打开程序</translation>
        </message>
        <message>
            <source>Default</source>
            <translation>默认值</translation>
        </message>
        <message>
            <source>Depth</source>
            <translation>深度</translation>
        </message>
        <message>
            <source>Depth limit</source>
            <translation>深度限制</translation>
        </message>
        <message>
            <source>Deviation</source>
            <translation>偏差</translation>
        </message>
        <message>
            <source>Deviation: not of a recording; psicarve verify tells it</source>
            <translation>偏差：不适用于记录；请用 psicarve verify</translation>
        </message>
        <message>
            <source>Diameter</source>
            <translation>直径</translation>
        </message>
        <message>
            <source>Diameter of the blank</source>
            <translation>毛坯直径</translation>
        </message>
        <message>
            <source>Diameter of the cylinder, mm</source>
            <translation>圆柱直径，mm</translation>
        </message>
        <message>
            <source>Diameter of the pin</source>
            <translation>销的直径</translation>
        </message>
        <message>
            <source>Direction of R2 minus 180 degrees, measured once.</source>
            <translation>R2 的方向减去 180 度，一次性测得。</translation>
        </message>
        <message>
            <source>Direction stands at least this long after a step's edge.</source>
            <translation>步进沿之后方向信号至少保持这么久。</translation>
        </message>
        <message>
            <source>Direction stands at least this long before a step's edge.</source>
            <translation>步进沿之前方向信号至少建立这么久。</translation>
        </message>
        <message>
            <source>Disarm</source>
            <translation>停用</translation>
        </message>
        <message>
            <source>Disarm keyboard jog</source>
            <translation>停用键盘点动</translation>
        </message>
        <message>
            <source>Dismiss</source>
            <translation>收起</translation>
        </message>
        <message>
            <source>Done</source>
            <translation>完成</translation>
        </message>
        <message>
            <source>Draft, of samples of the model: tips are kept %1 mm further out</source>
            <translation>草图，按模型的采样：刀尖向外多留 %1 mm</translation>
        </message>
        <message>
            <source>Drawings (%1)</source>
            <translation>图形 (%1)</translation>
        </message>
        <message>
            <source>Drives and spindle are off; the position is not certain any more.</source>
            <translation>驱动和主轴已关闭；位置不再可靠。</translation>
        </message>
        <message>
            <source>Drives and spindle may still be on, and nothing here can switch them off.</source>
            <translation>驱动和主轴可能仍然开着，这里无法将其关闭。</translation>
        </message>
        <message>
            <source>Drives and spindle may still be on: the port has not taken the order to switch them off. It is repeated until it does.</source>
            <translation>驱动和主轴可能仍然开启：端口没有接受关断命令。该命令会一直重复，直到端口接受。</translation>
        </message>
        <message>
            <source>Drives and spindle on</source>
            <translation>驱动和主轴开</translation>
        </message>
        <message>
            <source>Drives are off</source>
            <translation>驱动关</translation>
        </message>
        <message>
            <source>Drives off</source>
            <translation>关闭驱动</translation>
        </message>
        <message>
            <source>Drives off, not homed</source>
            <translation>驱动关闭，未回零</translation>
        </message>
        <message>
            <source>Drives off: they are off</source>
            <translation>关闭驱动：驱动已关闭</translation>
        </message>
        <message>
            <source>Drives on, spindle off</source>
            <translation>驱动开，主轴关</translation>
        </message>
        <message>
            <source>Drives switched off</source>
            <translation>驱动已关</translation>
        </message>
        <message>
            <source>Drives switched on</source>
            <translation>驱动开</translation>
        </message>
        <message>
            <source>Dry run</source>
            <translation>空运行</translation>
        </message>
        <message>
            <source>Dry run began with layer %2, point %3: %1</source>
            <translation>从第 %2 层第 %3 点开始空运行：%1</translation>
        </message>
        <message>
            <source>Dry run began with layer %2: %1</source>
            <translation>从第 %2 层开始空运行：%1</translation>
        </message>
        <message>
            <source>Dry run from layer %1, point %2: the heads go out and stay there, spindle off; table and Y go as they would from there.</source>
            <translation>从第 %1 层第 %2 点空运行：刀头退出并停在外面，主轴关闭；转台和 Y 从那里起照常运动。</translation>
        </message>
        <message>
            <source>Dry run from layer %1: the heads go out and stay there, spindle off; Y goes to the layer, then table and Y go as they would.</source>
            <translation>从第 %1 层空运行：刀头退出并停在外面，主轴关闭；Y 移到该层，然后转台和 Y 按作业运动。</translation>
        </message>
        <message>
            <source>Dry run from layer 1: the heads go out and stay there, spindle off; table and Y go as they would. Nothing is cut, and where the piece goes on stays known.</source>
            <translation>从第 1 层空运行：刀头退出并停在外面，主轴关闭；转台和 Y 按作业运动。不切削任何材料，工件从何处继续仍会记住。</translation>
        </message>
        <message>
            <source>Dry run, layer %1 of %2</source>
            <translation>空运行，第 %1 层，共 %2 层</translation>
        </message>
        <message>
            <source>Dry run: at its beginning</source>
            <translation>空运行：在起点</translation>
        </message>
        <message>
            <source>Dry run: to its beginning</source>
            <translation>空运行：移到起点</translation>
        </message>
        <message>
            <source>E-stop</source>
            <translation>急停</translation>
        </message>
        <message>
            <source>EMERGENCY STOP</source>
            <translation>急停</translation>
        </message>
        <message>
            <source>EXISTS asks for a parameter</source>
            <translation>EXISTS 只能查询参数</translation>
        </message>
        <message>
            <source>EXISTS[ has no ]</source>
            <translation>EXISTS[ 没有对应的 ]</translation>
        </message>
        <message>
            <source>Each block is a program of its own: G21 G17 G90 G94 G54 G80 hold before it, without a feed, and the spindle is off behind it.</source>
            <translation>每个程序段都是独立的程序：之前按 G21 G17 G90 G94 G54 G80，没有进给；之后主轴关闭。</translation>
        </message>
        <message>
            <source>Emergency stop</source>
            <translation>急停</translation>
        </message>
        <message>
            <source>Emergency stop asked for</source>
            <translation>已请求急停</translation>
        </message>
        <message>
            <source>Emergency stop switch pressed</source>
            <translation>急停开关按下</translation>
        </message>
        <message>
            <source>Emergency stop switch released</source>
            <translation>急停开关松开</translation>
        </message>
        <message>
            <source>Emitted since Start: the ways in and out, and back from a hold, as well</source>
            <translation>自启动起发出的脉冲：包括进刀、退刀和暂停后的返回</translation>
        </message>
        <message>
            <source>End</source>
            <translation>结尾</translation>
        </message>
        <message>
            <source>End at which the limit sensor stands.</source>
            <translation>限位传感器所在的一端。</translation>
        </message>
        <message>
            <source>End now</source>
            <translation>立即结束</translation>
        </message>
        <message>
            <source>End now: nothing is being measured</source>
            <translation>立即结束：没有在测量</translation>
        </message>
        <message>
            <source>End psicarve-rtcore, process %1</source>
            <translation>结束 psicarve-rtcore，进程 %1</translation>
        </message>
        <message>
            <source>Ends the job or program: heads out, spindle off (Shift+Esc)</source>
            <translation>结束作业或程序：刀头退出，主轴关闭（Shift+Esc）</translation>
        </message>
        <message>
            <source>Ends the program in order: heads out, spindle off (Shift+Esc)</source>
            <translation>有序结束程序：刀头退出，主轴关闭（Shift+Esc）</translation>
        </message>
        <message>
            <source>English</source>
            <translation>简体中文</translation>
        </message>
        <message>
            <source>Engrave its lines</source>
            <translation>雕刻线条</translation>
        </message>
        <message>
            <source>Entries of the recording</source>
            <translation>记录条目</translation>
        </message>
        <message>
            <source>Entry of kind %1</source>
            <translation>第 %1 类记录</translation>
        </message>
        <message>
            <source>Even with a height of its own; else the picture keeps its shape and the rest stays white</source>
            <translation>即使指定了高度也绕满整周；否则图片保持比例，其余部分为白色</translation>
        </message>
        <message>
            <source>Every edge of every pin into a file, from here on; a job that is carved whole meanwhile is verified</source>
            <translation>从现在起把每个引脚的每次跳变写入文件；期间完整雕刻的任务会被校验</translation>
        </message>
        <message>
            <source>Every pulse</source>
            <translation>每个脉冲</translation>
        </message>
        <message>
            <source>Expected piece</source>
            <translation>预期工件</translation>
        </message>
        <message>
            <source>F is along X, Y and Z, or of the faster tool over the piece, which turns under it.</source>
            <translation>F 为沿 X、Y、Z 的进给，或较快的刀具相对其下转动的工件的速度。</translation>
        </message>
        <message>
            <source>F stands beside new units, and counts in these</source>
            <translation>F 与单位切换同段，按新单位计</translation>
        </message>
        <message>
            <source>F1  emergency stop, everywhere
Shift+Esc  stop, everywhere
Esc  hold; in a dialog or menu: close it
Ctrl+Enter  start
Pause  hold, resume, everywhere
Ctrl+Home  home all
Ctrl+0, Ctrl+−, Ctrl++  feed override
Ctrl+O  open
F5  slice
F9  arm keyboard jog
Ctrl+1 … 8  tabs
Ctrl+L  layer number
F6  next pane
F10  menu
F12  this list</source>
            <translation>F1  急停，任何地方有效
Shift+Esc  停止，任何地方有效
Esc  暂停；在对话框或菜单中：将其关闭
Ctrl+Enter  启动
Pause  暂停、继续，任何地方有效
Ctrl+Home  全部回零
Ctrl+0、Ctrl+−、Ctrl++  进给倍率
Ctrl+O  打开
F5  切片
F9  启用键盘点动
Ctrl+1 … 8  页面
Ctrl+L  层号
F6  下一窗格
F10  菜单
F12  本列表</translation>
        </message>
        <message>
            <source>F1 · the live machine</source>
            <translation>F1 · 实际机床</translation>
        </message>
        <message>
            <source>F1 · works everywhere</source>
            <translation>F1 · 处处有效</translation>
        </message>
        <message>
            <source>FINISHING</source>
            <translation>收尾中</translation>
        </message>
        <message>
            <source>Feed override</source>
            <translation>进给倍率</translation>
        </message>
        <message>
            <source>Feed override %1 %</source>
            <translation>进给倍率 %1 %</translation>
        </message>
        <message>
            <source>Feed override %1 % → %2 %</source>
            <translation>进给倍率 %1 % → %2 %</translation>
        </message>
        <message>
            <source>Feed override: reset the alarm first</source>
            <translation>进给倍率：请先复位报警</translation>
        </message>
        <message>
            <source>Feed override: the machine is not homed</source>
            <translation>进给倍率：机床未回零</translation>
        </message>
        <message>
            <source>Feeds along a path through all points, or, of a head and Y, by point-by-point comparison.</source>
            <translation>进给沿经过所有点的路径运动；或者，一个刀头和 Y 的进给按逐点比较法运动。</translation>
        </message>
        <message>
            <source>File</source>
            <translation>文件</translation>
        </message>
        <message>
            <source>Find a key</source>
            <translation>查找参数</translation>
        </message>
        <message>
            <source>First Home all.</source>
            <translation>先“全部回零”。</translation>
        </message>
        <message>
            <source>First Home all: %1 are not homed.</source>
            <translation>先全部回零：%1 未回零。</translation>
        </message>
        <message>
            <source>First Home all: the drives are off.</source>
            <translation>先全部回零：驱动器已关闭。</translation>
        </message>
        <message>
            <source>First difference</source>
            <translation>第一处差异</translation>
        </message>
        <message>
            <source>First snapshot or job</source>
            <translation>第一个快照或作业</translation>
        </message>
        <message>
            <source>First start psicarve-rtcore, then Home all.</source>
            <translation>先启动 psicarve-rtcore，再全部回零。</translation>
        </message>
        <message>
            <source>First start psicarve-rtcore.</source>
            <translation>先启动 psicarve-rtcore。</translation>
        </message>
        <message>
            <source>Fit</source>
            <translation>适合</translation>
        </message>
        <message>
            <source>Flight recorder</source>
            <translation>飞行记录</translation>
        </message>
        <message>
            <source>Flood</source>
            <translation>冷却液</translation>
        </message>
        <message>
            <source>Flute length</source>
            <translation>刃长</translation>
        </message>
        <message>
            <source>Folder for the support bundle</source>
            <translation>支持包的文件夹</translation>
        </message>
        <message>
            <source>Follow the line</source>
            <translation>跟随当前行</translation>
        </message>
        <message>
            <source>Follow the machine</source>
            <translation>跟随机床</translation>
        </message>
        <message>
            <source>Follow the machine: it does not carve this job</source>
            <translation>跟随机床：机床没有在加工此作业</translation>
        </message>
        <message>
            <source>Forget</source>
            <translation>忘记</translation>
        </message>
        <message>
            <source>Forget it</source>
            <translation>忘记</translation>
        </message>
        <message>
            <source>Forget this piece</source>
            <translation>忘记此工件</translation>
        </message>
        <message>
            <source>Forget this piece…</source>
            <translation>忘记此工件…</translation>
        </message>
        <message>
            <source>Forgets for good how far this piece is carved; it asks first and moves nothing</source>
            <translation>永久忘记此工件的雕刻进度；会先询问，不产生任何运动</translation>
        </message>
        <message>
            <source>Forgets the zero of %1</source>
            <translation>清除 %1 的显示零点</translation>
        </message>
        <message>
            <source>Forget…</source>
            <translation>忘记…</translation>
        </message>
        <message>
            <source>Found</source>
            <translation>检查结果</translation>
        </message>
        <message>
            <source>From R1's mark to R2's, counter-clockwise from above is +</source>
            <translation>从 R1 的标记到 R2 的标记，俯视逆时针为 +</translation>
        </message>
        <message>
            <source>From layer</source>
            <translation>从层</translation>
        </message>
        <message>
            <source>From layer %1</source>
            <translation>从第 %1 层开始</translation>
        </message>
        <message>
            <source>From line</source>
            <translation>从行</translation>
        </message>
        <message>
            <source>From now on</source>
            <translation>新值</translation>
        </message>
        <message>
            <source>From point to point as the job's tables have it</source>
            <translation>按任务表逐点计算</translation>
        </message>
        <message>
            <source>From the flight recorder. A click goes to an entry.</source>
            <translation>来自飞行记录。单击转到该条。</translation>
        </message>
        <message>
            <source>From where most of the undercut is seen</source>
            <translation>从看得到最多倒扣的方向</translation>
        </message>
        <message>
            <source>From your zero of %1. The large number is the machine's own position.</source>
            <translation>从 %1 的显示零点算起。大号数字是机床自身的位置。</translation>
        </message>
        <message>
            <source>Front</source>
            <translation>前</translation>
        </message>
        <message>
            <source>G-code</source>
            <translation>G 代码</translation>
        </message>
        <message>
            <source>G0 of C turns as it is written, or the shortest way to the same direction.</source>
            <translation>C 的 G0 按所写的值转动，或以最短路径转到同一方向。</translation>
        </message>
        <message>
            <source>G10 L20 sets no rotation</source>
            <translation>G10 L20 不设置旋转</translation>
        </message>
        <message>
            <source>G10 has no L</source>
            <translation>G10 没有 L</translation>
        </message>
        <message>
            <source>G10 has no P, the system</source>
            <translation>G10 没有坐标系编号 P</translation>
        </message>
        <message>
            <source>G10 is read with L2 and L20</source>
            <translation>G10 只支持 L2 和 L20</translation>
        </message>
        <message>
            <source>G12.1 with the tip %1 mm from the axis, and there is no direction</source>
            <translation>G12.1：刀尖距轴线 %1 mm，没有方向</translation>
        </message>
        <message>
            <source>G12.1, and X 0 lies %1 mm off the axis</source>
            <translation>G12.1：X 0 偏离轴线 %1 mm</translation>
        </message>
        <message>
            <source>G12.1, and the program has not said yet where X and C are</source>
            <translation>G12.1：程序尚未给出 X 和 C 的位置</translation>
        </message>
        <message>
            <source>G12.1, and the tip of r2, which follows, stands %1 mm further in</source>
            <translation>G12.1：跟随的 r2 刀尖偏内 %1 mm</translation>
        </message>
        <message>
            <source>G12.1, and the tip of r2, which follows, stands %1 mm further out</source>
            <translation>G12.1：跟随的 r2 刀尖偏外 %1 mm</translation>
        </message>
        <message>
            <source>G4 has no P, the seconds</source>
            <translation>G4 没有秒数 P</translation>
        </message>
        <message>
            <source>G53 while G91 holds</source>
            <translation>G91 有效时使用 G53</translation>
        </message>
        <message>
            <source>G53 without a straight motion</source>
            <translation>G53 没有直线运动</translation>
        </message>
        <message>
            <source>G64 P of %1 mm; the machine can have %2 to %3 mm</source>
            <translation>G64 的 P 为 %1 mm；机床允许 %2 至 %3 mm</translation>
        </message>
        <message>
            <source>G7.1 has no C, the cylinder's radius</source>
            <translation>G7.1 没有圆柱半径 C</translation>
        </message>
        <message>
            <source>Gamma, smooth</source>
            <translation>伽马、平滑</translation>
        </message>
        <message>
            <source>General</source>
            <translation>常规</translation>
        </message>
        <message>
            <source>Gives the job to the core, which checks it</source>
            <translation>把作业交给内核检查</translation>
        </message>
        <message>
            <source>Go</source>
            <translation>移动</translation>
        </message>
        <message>
            <source>Go on with an unfinished piece</source>
            <translation>继续未完成的工件</translation>
        </message>
        <message>
            <source>Go to</source>
            <translation>移动到</translation>
        </message>
        <message>
            <source>Go to: an arc is of one head and Y</source>
            <translation>移动到：圆弧只用于一个刀头和 Y</translation>
        </message>
        <message>
            <source>Go to: choose an axis</source>
            <translation>移动到：请选择轴</translation>
        </message>
        <message>
            <source>Go to: two axes at most, step by step</source>
            <translation>移动到：逐步方式最多两个轴</translation>
        </message>
        <message>
            <source>Go to: Ψ moves in straight lines only</source>
            <translation>移动到：Ψ 只能直线运动</translation>
        </message>
        <message>
            <source>Go to…</source>
            <translation>移动到…</translation>
        </message>
        <message>
            <source>Goes on where it stands (Pause)</source>
            <translation>从停住处继续（Pause）</translation>
        </message>
        <message>
            <source>Greatest difference at an index pass that is not the alarm steps lost.</source>
            <translation>经过零位时不触发“丢步”报警的最大偏差。</translation>
        </message>
        <message>
            <source>Grooves are as wide as the strokes of an SVG drawing, at least as the tool</source>
            <translation>刻槽与 SVG 线条同宽，至少为刀具宽度</translation>
        </message>
        <message>
            <source>Grooves end at the core radius of %1 mm, less deep than asked.</source>
            <translation>刻槽止于芯半径 %1 mm，浅于要求的深度。</translation>
        </message>
        <message>
            <source>Grooves of the tool's width in a cylinder, instead of an extruded outline</source>
            <translation>在圆柱上刻出刀具宽度的槽，而不是拉伸轮廓</translation>
        </message>
        <message>
            <source>HELD</source>
            <translation>已暂停</translation>
        </message>
        <message>
            <source>HOLDING</source>
            <translation>暂停中</translation>
        </message>
        <message>
            <source>HOMING</source>
            <translation>回零</translation>
        </message>
        <message>
            <source>Head R2</source>
            <translation>刀头 R2</translation>
        </message>
        <message>
            <source>Head clearance</source>
            <translation>刀头间距</translation>
        </message>
        <message>
            <source>Heads move out this far after the last point, on stop, and on hold if on_hold says so.</source>
            <translation>最后一点之后、停止时，以及 on_hold 要求时暂停中，刀头退出这么远。</translation>
        </message>
        <message>
            <source>Heads out, spindle off</source>
            <translation>刀头退出，主轴关闭</translation>
        </message>
        <message>
            <source>Heads out, to point %2 of layer %1, then carve what is left (Ctrl+Enter)</source>
            <translation>刀头退出，到第 %1 层第 %2 点，然后雕刻其余部分（Ctrl+Enter）</translation>
        </message>
        <message>
            <source>Heads out, to the first point of layer %1, then carve what is left (Ctrl+Enter)</source>
            <translation>刀头退出，到第 %1 层的第一点，然后雕刻其余部分（Ctrl+Enter）</translation>
        </message>
        <message>
            <source>Heads to the first point, then carve (Ctrl+Enter)</source>
            <translation>刀头移到第一点，然后雕刻（Ctrl+Enter）</translation>
        </message>
        <message>
            <source>Height</source>
            <translation>高度</translation>
        </message>
        <message>
            <source>Height %1 mm</source>
            <translation>高度 %1 mm</translation>
        </message>
        <message>
            <source>Height sets it</source>
            <translation>由高度决定</translation>
        </message>
        <message>
            <source>Height, radius</source>
            <translation>高度，半径</translation>
        </message>
        <message>
            <source>Help</source>
            <translation>帮助</translation>
        </message>
        <message>
            <source>Here</source>
            <translation>此处</translation>
        </message>
        <message>
            <source>Here: no profile is open</source>
            <translation>此处：未打开配置</translation>
        </message>
        <message>
            <source>Hold</source>
            <translation>暂停</translation>
        </message>
        <message>
            <source>Hold = move, click = one step.</source>
            <translation>按住 = 移动，单击 = 一步。</translation>
        </message>
        <message>
            <source>Hold asked for by Esc: Resume or the Pause key goes on</source>
            <translation>已按 Esc 请求暂停：按“继续”或 Pause 键继续</translation>
        </message>
        <message>
            <source>Hold asked for: the window closes once the core has taken it</source>
            <translation>已请求暂停：内核接受后窗口将关闭</translation>
        </message>
        <message>
            <source>Hold for high</source>
            <translation>按住为高</translation>
        </message>
        <message>
            <source>Hold, Resume, Stop: nothing is moving.</source>
            <translation>暂停、继续、停止：没有运动。</translation>
        </message>
        <message>
            <source>Hold: nothing is carved</source>
            <translation>暂停：没有在雕刻</translation>
        </message>
        <message>
            <source>Hold: on hold already</source>
            <translation>暂停：已经暂停</translation>
        </message>
        <message>
            <source>Holds at M1</source>
            <translation>在 M1 处暂停</translation>
        </message>
        <message>
            <source>Holds behind each block; Resume goes on</source>
            <translation>每个程序段之后暂停；按“继续”接着运行</translation>
        </message>
        <message>
            <source>Holds every pulse against the job</source>
            <translation>用任务核对每个脉冲</translation>
        </message>
        <message>
            <source>Home</source>
            <translation>回零</translation>
        </message>
        <message>
            <source>Home %1</source>
            <translation>%1 回零</translation>
        </message>
        <message>
            <source>Home all</source>
            <translation>全部回零</translation>
        </message>
        <message>
            <source>Home before carving</source>
            <translation>雕刻前请先回零</translation>
        </message>
        <message>
            <source>Home Ψ: home R1 and R2 first</source>
            <translation>Ψ 回零：请先将 R1 和 R2 回零</translation>
        </message>
        <message>
            <source>Homed</source>
            <translation>已回零</translation>
        </message>
        <message>
            <source>Homed, job published</source>
            <translation>已回零，作业已发布</translation>
        </message>
        <message>
            <source>Homed, no job</source>
            <translation>已回零，无作业</translation>
        </message>
        <message>
            <source>Homing of axis %1 failed</source>
            <translation>轴 %1 回零失败</translation>
        </message>
        <message>
            <source>Homing: positions defined</source>
            <translation>回零：位置已确定</translation>
        </message>
        <message>
            <source>How deep black lies, mm</source>
            <translation>黑色的深度，mm</translation>
        </message>
        <message>
            <source>How deep the grooves are</source>
            <translation>刻槽深度</translation>
        </message>
        <message>
            <source>How deep the tool can cut</source>
            <translation>刀具能切多深</translation>
        </message>
        <message>
            <source>How deep the tool can cut; 0: deeper than any cut.</source>
            <translation>刀具能切多深；0：比任何切深都深。</translation>
        </message>
        <message>
            <source>How deep white lies, mm</source>
            <translation>白色的深度，mm</translation>
        </message>
        <message>
            <source>How far past the sensor the mechanics allow.</source>
            <translation>机械结构允许越过传感器的距离。</translation>
        </message>
        <message>
            <source>How far the unfinished piece is carved is forgotten for good, and with it the core's copy of its job. Nothing moves.</source>
            <translation>未完成工件的雕刻进度以及内核保存的作业副本将被永久忘记。不产生任何运动。</translation>
        </message>
        <message>
            <source>How late the core's ticks would be, beside whatever the computer does</source>
            <translation>在计算机做其他事的同时，内核节拍会迟多少</translation>
        </message>
        <message>
            <source>How late ticks were: number of ticks by lateness</source>
            <translation>节拍迟滞：按迟滞量统计的节拍数</translation>
        </message>
        <message>
            <source>How long to measure</source>
            <translation>测量时长</translation>
        </message>
        <message>
            <source>How many pulses</source>
            <translation>脉冲数</translation>
        </message>
        <message>
            <source>How much further in each roughing pass goes</source>
            <translation>每道粗加工比上一道深多少</translation>
        </message>
        <message>
            <source>How much further in each roughing pass goes; 0: the finishing pass alone.</source>
            <translation>每道粗加工比上一道深多少；0：只做精加工。</translation>
        </message>
        <message>
            <source>How much higher R2 stands than R1, measured once.</source>
            <translation>R2 比 R1 高出多少，一次性测得。</translation>
        </message>
        <message>
            <source>How much higher R2's mark is, lower is −</source>
            <translation>R2 的标记高出多少，低为 −</translation>
        </message>
        <message>
            <source>How the one before ended is not known</source>
            <translation>上一个内核如何结束不得而知</translation>
        </message>
        <message>
            <source>How to go there</source>
            <translation>移动方式</translation>
        </message>
        <message>
            <source>Hundreds of roughing passes</source>
            <translation>数百道粗加工</translation>
        </message>
        <message>
            <source>IDLE</source>
            <translation>空闲</translation>
        </message>
        <message>
            <source>INSERT of a block that is not there is left out.</source>
            <translation>INSERT 引用的块不存在，已略去。</translation>
        </message>
        <message>
            <source>INSERT of a block that is not there or holds itself is left out.</source>
            <translation>INSERT 引用的块不存在或包含自身，已略去。</translation>
        </message>
        <message>
            <source>If anything still moves, use the wired emergency stop</source>
            <translation>如仍有运动，请按硬接线急停</translation>
        </message>
        <message>
            <source>If the power fails, do not go on by it; see to the disk.</source>
            <translation>若断电，请勿据此继续；请检查磁盘。</translation>
        </message>
        <message>
            <source>In the file</source>
            <translation>文件中</translation>
        </message>
        <message>
            <source>In the file: %1</source>
            <translation>文件中为：%1</translation>
        </message>
        <message>
            <source>In the lowest layer the tool reaches %1 mm below the table's top: the table must be narrower than the job, or base_height_mm more.</source>
            <translation>在最低层，刀具低于转台台面 %1 mm：台面必须比作业窄，或者增大 base_height_mm。</translation>
        </message>
        <message>
            <source>In the recording</source>
            <translation>记录内容</translation>
        </message>
        <message>
            <source>Info</source>
            <translation>信息</translation>
        </message>
        <message>
            <source>Information</source>
            <translation>信息</translation>
        </message>
        <message>
            <source>Input pin 10..13 or 15; 0: not wired; minus: active low.</source>
            <translation>输入引脚 10..13 或 15；0：未接；负号：低电平有效。</translation>
        </message>
        <message>
            <source>Inputs active: %1</source>
            <translation>有效输入：%1</translation>
        </message>
        <message>
            <source>Inputs: none active</source>
            <translation>输入：均无效</translation>
        </message>
        <message>
            <source>Invert</source>
            <translation>反相</translation>
        </message>
        <message>
            <source>Is the disk full, or the folder another user's?</source>
            <translation>磁盘已满，还是文件夹属于其他用户？</translation>
        </message>
        <message>
            <source>Iso</source>
            <translation>轴测</translation>
        </message>
        <message>
            <source>It ended in layer %1, point %2.</source>
            <translation>停在第 %1 层第 %2 点。</translation>
        </message>
        <message>
            <source>It is not offered again; the file stays</source>
            <translation>不再提示；文件保留</translation>
        </message>
        <message>
            <source>It is the first one</source>
            <translation>这是第一个内核</translation>
        </message>
        <message>
            <source>It was begun with another profile of the machine.</source>
            <translation>它是用另一份机床配置开始的。</translation>
        </message>
        <message>
            <source>Its core is gone, and its flight recorder with it</source>
            <translation>其内核已不在，飞行记录也随之消失</translation>
        </message>
        <message>
            <source>Its guard could not switch drives and spindle off: the port does not answer.</source>
            <translation>其守护进程未能关闭驱动和主轴：端口无响应。</translation>
        </message>
        <message>
            <source>Its guard has switched drives and spindle off.</source>
            <translation>其守护进程已关闭驱动和主轴。</translation>
        </message>
        <message>
            <source>Its line at the end</source>
            <translation>结束时所在行</translation>
        </message>
        <message>
            <source>Its sensor was not found, or did not clear. Likely a broken wire or a sensor out of place.</source>
            <translation>未找到其传感器，或传感器未释放。可能断线或传感器移位。</translation>
        </message>
        <message>
            <source>JSON (*.json)</source>
            <translation>JSON (*.json)</translation>
        </message>
        <message>
            <source>Job</source>
            <translation>作业</translation>
        </message>
        <message>
            <source>Job done: %1</source>
            <translation>作业完成：%1</translation>
        </message>
        <message>
            <source>Job ended by an alarm in layer %2: %1</source>
            <translation>作业因报警在第 %2 层结束：%1</translation>
        </message>
        <message>
            <source>Job in the machine</source>
            <translation>机床中的作业</translation>
        </message>
        <message>
            <source>Job in travel</source>
            <translation>作业在行程内</translation>
        </message>
        <message>
            <source>Job loaded: %1, %2 layers of %3 points</source>
            <translation>作业已载入：%1，%2 层，每层 %3 点</translation>
        </message>
        <message>
            <source>Job no. %1 accepted</source>
            <translation>作业 %1 号已接受</translation>
        </message>
        <message>
            <source>Job or snapshot of this trace</source>
            <translation>此轨迹的作业或快照</translation>
        </message>
        <message>
            <source>Job published</source>
            <translation>作业已发布</translation>
        </message>
        <message>
            <source>Job refused</source>
            <translation>作业被拒绝</translation>
        </message>
        <message>
            <source>Job stopped in layer %2: %1</source>
            <translation>作业在第 %2 层停止：%1</translation>
        </message>
        <message>
            <source>Job, state and flight recorder of the machine, to be looked at later</source>
            <translation>机床的任务、状态和运行记录，供以后查看</translation>
        </message>
        <message>
            <source>Job: %1 × %2 points</source>
            <translation>作业：%1 × %2 点</translation>
        </message>
        <message>
            <source>Jobs (%1)</source>
            <translation>作业 (%1)</translation>
        </message>
        <message>
            <source>Jobs (*.job *.psi)</source>
            <translation>任务 (*.job *.psi)</translation>
        </message>
        <message>
            <source>Jobs and snapshots (*.job *.psi *.snap);;All files (*)</source>
            <translation>作业和快照 (*.job *.psi *.snap);;所有文件 (*)</translation>
        </message>
        <message>
            <source>Jog</source>
            <translation>点动</translation>
        </message>
        <message>
            <source>Jog ends</source>
            <translation>点动结束</translation>
        </message>
        <message>
            <source>Jog speed of R1, R2 and Y</source>
            <translation>R1、R2 和 Y 的点动速度</translation>
        </message>
        <message>
            <source>Jog speed of Ψ</source>
            <translation>Ψ 的点动速度</translation>
        </message>
        <message>
            <source>Jog: the machine is not homed</source>
            <translation>点动：机床未回零</translation>
        </message>
        <message>
            <source>Jogging</source>
            <translation>点动</translation>
        </message>
        <message>
            <source>Joining</source>
            <translation>层间连接</translation>
        </message>
        <message>
            <source>Judged</source>
            <translation>检验范围</translation>
        </message>
        <message>
            <source>Judged by the job that is open</source>
            <translation>按已打开的作业判定</translation>
        </message>
        <message>
            <source>Judged by the job that the trace carries</source>
            <translation>按轨迹中所带的作业判定</translation>
        </message>
        <message>
            <source>Judged up to</source>
            <translation>检验到</translation>
        </message>
        <message>
            <source>K  play, pause
J, L  slower, faster
N, Shift+N  next entry, entry before
,  .  one layer
Arrows, PgUp, PgDn, Home, End  on the timeline</source>
            <translation>K  播放、暂停
J、L  慢、快
N、Shift+N  下一条、上一条记录
,  .  一层
方向键、PgUp、PgDn、Home、End  在时间轴上</translation>
        </message>
        <message>
            <source>Keeps the line that runs in sight</source>
            <translation>使正在运行的行保持可见</translation>
        </message>
        <message>
            <source>Key</source>
            <translation>键</translation>
        </message>
        <message>
            <source>Keys</source>
            <translation>按键</translation>
        </message>
        <message>
            <source>Keys move the machine; F9 ends it.</source>
            <translation>按键正在移动机床；F9 结束。</translation>
        </message>
        <message>
            <source>Keys…</source>
            <translation>按键…</translation>
        </message>
        <message>
            <source>Kind</source>
            <translation>类别</translation>
        </message>
        <message>
            <source>L of M66 is 0 to 4</source>
            <translation>M66 的 L 为 0 至 4</translation>
        </message>
        <message>
            <source>L of M66 is a way to wait</source>
            <translation>M66 的 L 是等待方式</translation>
        </message>
        <message>
            <source>LN of a value that is not above 0</source>
            <translation>LN 的自变量不大于 0</translation>
        </message>
        <message>
            <source>Language</source>
            <translation>语言</translation>
        </message>
        <message>
            <source>Largest</source>
            <translation>最大</translation>
        </message>
        <message>
            <source>Largest deviation</source>
            <translation>最大偏差</translation>
        </message>
        <message>
            <source>Largest sets it</source>
            <translation>由“最大”决定</translation>
        </message>
        <message>
            <source>Last good layer: %1.</source>
            <translation>最后完好的层：%1。</translation>
        </message>
        <message>
            <source>Last good: layer %1, to its point %2.</source>
            <translation>最后完好：第 %1 层，到第 %2 点。</translation>
        </message>
        <message>
            <source>Late: median, 99 %, 99.9 %</source>
            <translation>迟滞：中位、99 %、99.9 %</translation>
        </message>
        <message>
            <source>Latest of all</source>
            <translation>最大迟滞</translation>
        </message>
        <message>
            <source>Layer</source>
            <translation>层</translation>
        </message>
        <message>
            <source>Layer %1</source>
            <translation>第 %1 层</translation>
        </message>
        <message>
            <source>Layer %1 / %2 · point %3 / %4 · elapsed %5 · override %6 %</source>
            <translation>层 %1 / %2 · 点 %3 / %4 · 已用 %5 · 倍率 %6 %</translation>
        </message>
        <message>
            <source>Layer %1 / %2, point %3 / %4</source>
            <translation>层 %1 / %2，点 %3 / %4</translation>
        </message>
        <message>
            <source>Layer %1 can be wrong%2</source>
            <translation>第 %1 层可能有误%2</translation>
        </message>
        <message>
            <source>Layer %1 of %2</source>
            <translation>第 %1 层，共 %2 层</translation>
        </message>
        <message>
            <source>Layer %1 was the last that was finished.</source>
            <translation>第 %1 层是最后完成的层。</translation>
        </message>
        <message>
            <source>Layer 1 of %1 is carved and would be carved again.</source>
            <translation>第 1 层（共 %1 层）已雕刻，将会再次雕刻。</translation>
        </message>
        <message>
            <source>Layer and point are those of the machine, until others are chosen</source>
            <translation>层和点随机床变化，直到另选为止</translation>
        </message>
        <message>
            <source>Layer time</source>
            <translation>本层时间</translation>
        </message>
        <message>
            <source>Layer to start from</source>
            <translation>起始层</translation>
        </message>
        <message>
            <source>Layers</source>
            <translation>层</translation>
        </message>
        <message>
            <source>Layers %1 to %2 can be wrong%3</source>
            <translation>第 %1 至 %2 层可能有误%3</translation>
        </message>
        <message>
            <source>Layers 1 to %1 of %2 are carved and would be carved again.</source>
            <translation>第 1 至 %1 层（共 %2 层）已雕刻，将会再次雕刻。</translation>
        </message>
        <message>
            <source>Layers and points lie farther from each other than the tool cuts, %1 mm: choose more of them.</source>
            <translation>层距和点距大于刀具切宽 %1 mm：请增加层数或点数。</translation>
        </message>
        <message>
            <source>Layers × points</source>
            <translation>层 × 点</translation>
        </message>
        <message>
            <source>Least distance between the two tool tips.</source>
            <translation>两个刀尖之间的最小距离。</translation>
        </message>
        <message>
            <source>Leave replay</source>
            <translation>退出回放</translation>
        </message>
        <message>
            <source>Leave running</source>
            <translation>继续运行</translation>
        </message>
        <message>
            <source>Leaves out blocks that begin with /</source>
            <translation>跳过以 / 开头的程序段</translation>
        </message>
        <message>
            <source>Leaves out the layers before it</source>
            <translation>跳过它之前的层</translation>
        </message>
        <message>
            <source>Leaves out the layers before it; %1 was the last that was finished</source>
            <translation>跳过此前的层；最后完成的是第 %1 层</translation>
        </message>
        <message>
            <source>Leaves replay and opens the job in this snapshot</source>
            <translation>退出回放并打开快照中的作业</translation>
        </message>
        <message>
            <source>Left out, as they are no lines: %1.</source>
            <translation>非线条，已略去：%1。</translation>
        </message>
        <message>
            <source>Left over %1 mm at most, at %2°, %3 mm high; %4 mm on average</source>
            <translation>余料最多 %1 mm，在 %2°、高 %3 mm 处；平均 %4 mm</translation>
        </message>
        <message>
            <source>Letters for R1, R2, Y and Psi: X, Z, Y and C, or, as lathes have them, X, U, Z and C.</source>
            <translation>R1、R2、Y 和 Psi 的字母：X、Z、Y 和 C，或按车床习惯为 X、U、Z 和 C。</translation>
        </message>
        <message>
            <source>Level</source>
            <translation>电平</translation>
        </message>
        <message>
            <source>Level of the direction pin that means positive.</source>
            <translation>表示正方向的方向引脚电平。</translation>
        </message>
        <message>
            <source>Levels of all pins in the last 20 seconds</source>
            <translation>最近 20 秒所有引脚的电平</translation>
        </message>
        <message>
            <source>Light</source>
            <translation>浅色</translation>
        </message>
        <message>
            <source>Limit switch %1</source>
            <translation>限位开关 %1</translation>
        </message>
        <message>
            <source>Limit switch %1 closed</source>
            <translation>限位开关 %1 闭合</translation>
        </message>
        <message>
            <source>Limit switch %1 closed (inner end, pin %2)</source>
            <translation>限位开关 %1 闭合（内端，引脚 %2）</translation>
        </message>
        <message>
            <source>Limit switch %1 closed (outer end, pin %2)</source>
            <translation>限位开关 %1 闭合（外端，引脚 %2）</translation>
        </message>
        <message>
            <source>Limit switch %1 open</source>
            <translation>限位开关 %1 断开</translation>
        </message>
        <message>
            <source>Limit switch Y closed (lower end, pin %1)</source>
            <translation>限位开关 Y 闭合（下端，引脚 %1）</translation>
        </message>
        <message>
            <source>Limit switch Y closed (upper end, pin %1)</source>
            <translation>限位开关 Y 闭合（上端，引脚 %1）</translation>
        </message>
        <message>
            <source>Limits clear</source>
            <translation>限位均断开</translation>
        </message>
        <message>
            <source>Line %1</source>
            <translation>第 %1 行</translation>
        </message>
        <message>
            <source>Line %1, column %2</source>
            <translation>第 %1 行第 %2 列</translation>
        </message>
        <message>
            <source>Line to begin with</source>
            <translation>起始行</translation>
        </message>
        <message>
            <source>Lines: %1, moves: %2, errors: %3, warnings: %4</source>
            <translation>行：%1，运动：%2，错误：%3，警告：%4</translation>
        </message>
        <message>
            <source>Live machine: %1</source>
            <translation>实际机床：%1</translation>
        </message>
        <message>
            <source>Load the computer meanwhile as it will be loaded: an hour says more than a minute.</source>
            <translation>测量时请让计算机承受实际负载：一小时比一分钟更说明问题。</translation>
        </message>
        <message>
            <source>Locked by the wiring test</source>
            <translation>接线测试中，已锁定</translation>
        </message>
        <message>
            <source>Locked on hold: resume or stop</source>
            <translation>暂停中锁定：请继续或停止</translation>
        </message>
        <message>
            <source>Locked on hold: stop</source>
            <translation>暂停时锁定：请停止</translation>
        </message>
        <message>
            <source>Locked until the alarm is reset</source>
            <translation>报警复位前锁定</translation>
        </message>
        <message>
            <source>Locked while a program runs</source>
            <translation>程序运行时锁定</translation>
        </message>
        <message>
            <source>Locked while an axis moves</source>
            <translation>轴运动时锁定</translation>
        </message>
        <message>
            <source>Locked while carving</source>
            <translation>雕刻时锁定</translation>
        </message>
        <message>
            <source>Locked while the machine homes</source>
            <translation>回零时锁定</translation>
        </message>
        <message>
            <source>Locked while the machine stops</source>
            <translation>停止过程中锁定</translation>
        </message>
        <message>
            <source>Locked: the heads wait at the first point; start or stop</source>
            <translation>锁定：刀头在第一点等待；请启动或停止</translation>
        </message>
        <message>
            <source>Log saved: %1</source>
            <translation>日志已保存：%1</translation>
        </message>
        <message>
            <source>Logical levels, looked at 30 times a second; steps by how many there were in between. A recording holds every edge.</source>
            <translation>逻辑电平，每秒查看 30 次；步进按其间的脉冲数显示。记录文件含每次跳变。</translation>
        </message>
        <message>
            <source>Look for what held the table back and lower its speed or acceleration if nothing did; reset the alarm, then home.</source>
            <translation>查找阻碍转台的原因；若没有，请降低其速度或加速度；复位报警，然后回零。</translation>
        </message>
        <message>
            <source>Look for what holds the table</source>
            <translation>查找卡住转台的原因</translation>
        </message>
        <message>
            <source>Looking at this computer</source>
            <translation>正在检查本机</translation>
        </message>
        <message>
            <source>Looking for the sensors</source>
            <translation>正在寻找传感器</translation>
        </message>
        <message>
            <source>Lost at work</source>
            <translation>工作中丢失</translation>
        </message>
        <message>
            <source>Lowest and highest position.</source>
            <translation>最低和最高位置。</translation>
        </message>
        <message>
            <source>Lowest point of the model above the table; baked into a job's heights.</source>
            <translation>模型最低点在台面以上的高度；计入作业的各层高度。</translation>
        </message>
        <message>
            <source>M4: the machine's spindle does not turn back</source>
            <translation>M4：机床主轴不能反转</translation>
        </message>
        <message>
            <source>M98 has no P, the number of the subroutine</source>
            <translation>M98 没有子程序编号 P</translation>
        </message>
        <message>
            <source>M99 ends what M98 has called, and endsub what call has</source>
            <translation>M99 结束由 M98 调用的子程序，endsub 结束由 call 调用的</translation>
        </message>
        <message>
            <source>M99 in the main program begins it again for ever</source>
            <translation>主程序中的 M99 会使其无限重复</translation>
        </message>
        <message>
            <source>MDI</source>
            <translation>MDI</translation>
        </message>
        <message>
            <source>MOVING</source>
            <translation>移动中</translation>
        </message>
        <message>
            <source>Machine</source>
            <translation>机床</translation>
        </message>
        <message>
            <source>Machine profile</source>
            <translation>机床配置</translation>
        </message>
        <message>
            <source>Machine: %1</source>
            <translation>机床：%1</translation>
        </message>
        <message>
            <source>Makes the job's tables (F5)</source>
            <translation>生成作业的数据表（F5）</translation>
        </message>
        <message>
            <source>Measure</source>
            <translation>测量</translation>
        </message>
        <message>
            <source>Measure: the machine is at work, and would be disturbed</source>
            <translation>测量：机床在工作，会受到干扰</translation>
        </message>
        <message>
            <source>Measure: under way</source>
            <translation>测量：进行中</translation>
        </message>
        <message>
            <source>Measured %1 ticks: 99.9 % at most %2 late, %3 missed</source>
            <translation>已测量 %1 个节拍：99.9 % 最多迟 %2，错过 %3</translation>
        </message>
        <message>
            <source>Menu</source>
            <translation>菜单</translation>
        </message>
        <message>
            <source>Menu (F10)</source>
            <translation>菜单（F10）</translation>
        </message>
        <message>
            <source>Mesh</source>
            <translation>网格</translation>
        </message>
        <message>
            <source>Meshes (%1)</source>
            <translation>网格 (%1)</translation>
        </message>
        <message>
            <source>Messages</source>
            <translation>消息</translation>
        </message>
        <message>
            <source>Mirror along</source>
            <translation>镜像轴</translation>
        </message>
        <message>
            <source>Missed ticks</source>
            <translation>错过的周期</translation>
        </message>
        <message>
            <source>Missed, skipped</source>
            <translation>丢失、跳过</translation>
        </message>
        <message>
            <source>Mist</source>
            <translation>喷雾</translation>
        </message>
        <message>
            <source>Model</source>
            <translation>模型</translation>
        </message>
        <message>
            <source>More than %1 mm on %2 % of the surface</source>
            <translation>超过 %1 mm 的占表面 %2 %</translation>
        </message>
        <message>
            <source>Motion and slicing go by the core's. %1</source>
            <translation>运动和切片以内核的配置为准。%1</translation>
        </message>
        <message>
            <source>Motor pulses for one millimetre.</source>
            <translation>每毫米的电机脉冲数。</translation>
        </message>
        <message>
            <source>Motor pulses for one turn of the table; even.</source>
            <translation>转台一圈的电机脉冲数；偶数。</translation>
        </message>
        <message>
            <source>Moves the axis away from its closed switch, slowly</source>
            <translation>把轴缓慢移离闭合的开关</translation>
        </message>
        <message>
            <source>NO</source>
            <translation>否</translation>
        </message>
        <message>
            <source>NO CORE</source>
            <translation>无内核</translation>
        </message>
        <message>
            <source>Name of the machine, for people.</source>
            <translation>机床名称，供人识别。</translation>
        </message>
        <message>
            <source>Needs restart: the core has %1 until it is started anew</source>
            <translation>需要重启：内核重新启动前使用 %1</translation>
        </message>
        <message>
            <source>New</source>
            <translation>新值</translation>
        </message>
        <message>
            <source>Next</source>
            <translation>下一步</translation>
        </message>
        <message>
            <source>No alarm</source>
            <translation>无报警</translation>
        </message>
        <message>
            <source>No copy of its job is there: open that very job, publish it, Home all, then go on from layer %1.</source>
            <translation>没有其作业的副本：打开同一个作业，发布它，全部回零，然后从第 %1 层继续。</translation>
        </message>
        <message>
            <source>No core has been seen yet</source>
            <translation>尚未见到内核</translation>
        </message>
        <message>
            <source>No core serves the segment</source>
            <translation>没有内核服务此共享段</translation>
        </message>
        <message>
            <source>No core took it: it has stopped nothing, and drives and spindle are as they were.</source>
            <translation>没有内核接收：未停止任何动作，驱动和主轴保持原状。</translation>
        </message>
        <message>
            <source>No core: these are the last figures known</source>
            <translation>无内核：这些是最后已知的数值</translation>
        </message>
        <message>
            <source>No core: these are the last levels known.</source>
            <translation>无内核：这些是最后已知的电平。</translation>
        </message>
        <message>
            <source>No job</source>
            <translation>无作业</translation>
        </message>
        <message>
            <source>No job is published.</source>
            <translation>没有已发布的作业。</translation>
        </message>
        <message>
            <source>No job running</source>
            <translation>没有正在运行的作业</translation>
        </message>
        <message>
            <source>No job: slice a model or open a job</source>
            <translation>无作业：请切片模型或打开作业</translation>
        </message>
        <message>
            <source>No key has these letters</source>
            <translation>没有包含这些字母的参数</translation>
        </message>
        <message>
            <source>No model. Open one from the menu, or drop a file here.</source>
            <translation>无模型。请从菜单打开，或将文件拖放到此处。</translation>
        </message>
        <message>
            <source>No program is open.</source>
            <translation>没有打开程序。</translation>
        </message>
        <message>
            <source>No tick by a real clock so far</source>
            <translation>尚无实时时钟节拍</translation>
        </message>
        <message>
            <source>No tick missed in the last second; %1 before</source>
            <translation>最近一秒未丢节拍；此前 %1 个</translation>
        </message>
        <message>
            <source>No tick missed since the core started</source>
            <translation>内核启动以来未丢节拍</translation>
        </message>
        <message>
            <source>No tip goes deeper than this below the blank's surface</source>
            <translation>刀尖在毛坯表面以下不超过此深度</translation>
        </message>
        <message>
            <source>No tip goes deeper than this below the cylinder's surface; 0: no limit.</source>
            <translation>刀尖在圆柱表面以下不超过此深度；0：不限。</translation>
        </message>
        <message>
            <source>No zero</source>
            <translation>清除 Δ</translation>
        </message>
        <message>
            <source>Nobody heard the emergency stop</source>
            <translation>急停无人响应</translation>
        </message>
        <message>
            <source>Nobody heard the emergency stop: it has stopped nothing</source>
            <translation>急停无人响应：未停止任何动作</translation>
        </message>
        <message>
            <source>None yet</source>
            <translation>暂无</translation>
        </message>
        <message>
            <source>Not homed, job published</source>
            <translation>未回零，作业已发布</translation>
        </message>
        <message>
            <source>Not known yet: the job is planned while the machine rests</source>
            <translation>尚不清楚：机床静止时才规划作业</translation>
        </message>
        <message>
            <source>Not known: the job could not be planned; page Messages says why</source>
            <translation>未知：无法规划该作业；原因见“消息”页</translation>
        </message>
        <message>
            <source>Not known: the job of a recording is not planned</source>
            <translation>未知：不规划记录中的作业</translation>
        </message>
        <message>
            <source>Not now</source>
            <translation>暂不</translation>
        </message>
        <message>
            <source>Not opened, as the machine's profile was not: %1</source>
            <translation>未打开，因为机床配置未能打开：%1</translation>
        </message>
        <message>
            <source>Not opened: %1</source>
            <translation>未打开：%1</translation>
        </message>
        <message>
            <source>Not published</source>
            <translation>未发布</translation>
        </message>
        <message>
            <source>Not published when a window ended: %1 (page Model)</source>
            <translation>窗口结束时尚未发布：%1（模型页）</translation>
        </message>
        <message>
            <source>Not saved: %1</source>
            <translation>未保存：%1</translation>
        </message>
        <message>
            <source>Not saved: %1 is open here, and would be lost; choose another name</source>
            <translation>未保存：%1 正在此处打开，会丢失；请换一个名称</translation>
        </message>
        <message>
            <source>Not sliced</source>
            <translation>未切片</translation>
        </message>
        <message>
            <source>Not sliced yet.</source>
            <translation>尚未切片。</translation>
        </message>
        <message>
            <source>Nothing before this line moves anything.</source>
            <translation>此行之前没有任何运动。</translation>
        </message>
        <message>
            <source>Nothing differs from the built-in profile</source>
            <translation>与内置配置没有差别</translation>
        </message>
        <message>
            <source>Nothing is carved closer to the axis.</source>
            <translation>不会雕刻到比此更靠近轴心处。</translation>
        </message>
        <message>
            <source>Nothing is left of it but to stop</source>
            <translation>只能停止它</translation>
        </message>
        <message>
            <source>Nothing is left over</source>
            <translation>没有余料</translation>
        </message>
        <message>
            <source>Nothing is open.</source>
            <translation>没有打开的文件。</translation>
        </message>
        <message>
            <source>Nothing is wrong.</source>
            <translation>一切正常。</translation>
        </message>
        <message>
            <source>Nothing moves in this plane.</source>
            <translation>此平面内没有运动。</translation>
        </message>
        <message>
            <source>Nothing was changed</source>
            <translation>没有修改</translation>
        </message>
        <message>
            <source>Nowhere too deep</source>
            <translation>没有过深之处</translation>
        </message>
        <message>
            <source>O has neither a number nor a &lt;name&gt;</source>
            <translation>O 后既没有数字也没有 &lt;名称&gt;</translation>
        </message>
        <message>
            <source>O%1 has gone by in the stream</source>
            <translation>O%1 在数据流中已经过去</translation>
        </message>
        <message>
            <source>OFF in other than 3 dimensions</source>
            <translation>不是三维的 OFF</translation>
        </message>
        <message>
            <source>OFF that is binary; save it as text</source>
            <translation>二进制 OFF；请另存为文本</translation>
        </message>
        <message>
            <source>Of &lt;style&gt; only rules for element names, .class and #id are followed, not %1.</source>
            <translation>&lt;style&gt; 中只采用针对元素名、.class 和 #id 的规则，不采用 %1。</translation>
        </message>
        <message>
            <source>Of the body that becomes of it</source>
            <translation>由此生成的实体的高度</translation>
        </message>
        <message>
            <source>Of the faster head's tool over the surface, in the last second</source>
            <translation>较快刀头的刀具相对工件表面的速度，最近一秒</translation>
        </message>
        <message>
            <source>Of the picture's 16 bits 8 are taken, as its samples lie in planes.</source>
            <translation>图片的各通道分平面存放，16 位中只取 8 位。</translation>
        </message>
        <message>
            <source>Of the rapid ways of a program in G-code</source>
            <translation>用于 G 代码程序的快速移动</translation>
        </message>
        <message>
            <source>Of the tool where it is widest.</source>
            <translation>刀具最宽处的直径。</translation>
        </message>
        <message>
            <source>Of top speed</source>
            <translation>占最高速度</translation>
        </message>
        <message>
            <source>Of which time messages are shown</source>
            <translation>显示哪段时间的消息</translation>
        </message>
        <message>
            <source>On a round blank let R1 make a mark: a touch of its tip. Take it out, turn Ψ by exactly 180°, leave Y alone, and let R2 make its own. On a machine without error it falls on R1's.</source>
            <translation>在圆毛坯上让 R1 的刀尖轻触，做一个标记。退出后将 Ψ 正好转 180°，Y 不动，再让 R2 做标记。无误差的机床上两者重合。</translation>
        </message>
        <message>
            <source>On hold the heads stay in the cut, or leave it by retract_mm and come back before it goes on.</source>
            <translation>暂停时刀头留在切口中，或退出 retract_mm，继续之前再返回。</translation>
        </message>
        <message>
            <source>On the desk</source>
            <translation>在此窗口中</translation>
        </message>
        <message>
            <source>On the virtual clock nothing has to be in time</source>
            <translation>虚拟时钟下没有准时要求</translation>
        </message>
        <message>
            <source>On this piece that takes time and cuts nothing. A new blank has to begin with layer 1.</source>
            <translation>对这个工件只是费时，不切削任何材料。新毛坯必须从第 1 层开始。</translation>
        </message>
        <message>
            <source>One block of G-code, run by Return</source>
            <translation>一个 G 代码程序段，按回车运行</translation>
        </message>
        <message>
            <source>One block; Return runs it</source>
            <translation>一个程序段；按回车运行</translation>
        </message>
        <message>
            <source>One layer</source>
            <translation>一层</translation>
        </message>
        <message>
            <source>One output by hand</source>
            <translation>手动单个输出</translation>
        </message>
        <message>
            <source>One timer for everything, or the original's two.</source>
            <translation>一个定时器负责全部，或采用原机的两个。</translation>
        </message>
        <message>
            <source>Only an alarm has a place in the flight recorder</source>
            <translation>只有报警在飞行记录中有位置</translation>
        </message>
        <message>
            <source>Open</source>
            <translation>打开</translation>
        </message>
        <message>
            <source>Open a machine profile</source>
            <translation>打开机床配置</translation>
        </message>
        <message>
            <source>Open a program</source>
            <translation>打开程序</translation>
        </message>
        <message>
            <source>Open a program…</source>
            <translation>打开程序…</translation>
        </message>
        <message>
            <source>Open in directions</source>
            <translation>开口方向</translation>
        </message>
        <message>
            <source>Open its job</source>
            <translation>打开其作业</translation>
        </message>
        <message>
            <source>Open its job, publish it, Home all, then go on from layer %1.</source>
            <translation>打开其作业，发布它，全部回零，然后从第 %1 层继续。</translation>
        </message>
        <message>
            <source>Open its job, then go on from layer %1.</source>
            <translation>打开其作业，然后从第 %1 层继续。</translation>
        </message>
        <message>
            <source>Open its job: this snapshot has none</source>
            <translation>打开其作业：此快照中没有作业</translation>
        </message>
        <message>
            <source>Open model, job, program or recording</source>
            <translation>打开模型、作业、程序或记录</translation>
        </message>
        <message>
            <source>Open model, job, program or recording…</source>
            <translation>打开模型、作业、程序或记录…</translation>
        </message>
        <message>
            <source>Open points</source>
            <translation>开口点</translation>
        </message>
        <message>
            <source>Open recent</source>
            <translation>最近的文件</translation>
        </message>
        <message>
            <source>Open...</source>
            <translation>打开...</translation>
        </message>
        <message>
            <source>Open: a job is being made; cancel it first</source>
            <translation>打开：正在生成作业；请先取消</translation>
        </message>
        <message>
            <source>Open: the machine's profile is still being read</source>
            <translation>打开：机床配置仍在读取</translation>
        </message>
        <message>
            <source>OpenGL took the window down the last time: drawing without it</source>
            <translation>上次 OpenGL 使窗口崩溃：现在不用它绘图</translation>
        </message>
        <message>
            <source>Opened %1</source>
            <translation>已打开 %1</translation>
        </message>
        <message>
            <source>Opened without its model: there is nothing to compare the piece with</source>
            <translation>打开时没有模型：工件无可比较</translation>
        </message>
        <message>
            <source>Opens the copy of the job that the core has kept; it publishes and moves nothing</source>
            <translation>打开内核保存的作业副本；不发布，也不产生任何运动</translation>
        </message>
        <message>
            <source>Opens the model with the form it had</source>
            <translation>按原来的设置打开模型</translation>
        </message>
        <message>
            <source>Opens what the core has recorded, at the moment of this alarm; it moves nothing</source>
            <translation>打开内核在该报警时刻的记录；不会移动任何东西</translation>
        </message>
        <message>
            <source>Optional stop</source>
            <translation>选择停止</translation>
        </message>
        <message>
            <source>Optional stop off</source>
            <translation>选择停止关</translation>
        </message>
        <message>
            <source>Optional stop on</source>
            <translation>选择停止开</translation>
        </message>
        <message>
            <source>Output %1</source>
            <translation>输出 %1</translation>
        </message>
        <message>
            <source>Output pin 1..9, 14, 16 or 17; 0: not wired; minus: active low.</source>
            <translation>输出引脚 1..9、14、16 或 17；0：未接；负号：低电平有效。</translation>
        </message>
        <message>
            <source>Output to test</source>
            <translation>要测试的输出</translation>
        </message>
        <message>
            <source>Override of rapids</source>
            <translation>快速倍率</translation>
        </message>
        <message>
            <source>Override of rapids %1 %</source>
            <translation>快速倍率 %1 %</translation>
        </message>
        <message>
            <source>Override of rapids %1 % → %2 %</source>
            <translation>快速倍率 %1 % → %2 %</translation>
        </message>
        <message>
            <source>P is a number of an output</source>
            <translation>P 是输出的编号</translation>
        </message>
        <message>
            <source>P is a system's number</source>
            <translation>P 是坐标系编号</translation>
        </message>
        <message>
            <source>P is the number of a subroutine</source>
            <translation>P 是子程序编号</translation>
        </message>
        <message>
            <source>P of %1 is 0, off, or 1, on</source>
            <translation>%1 的 P 为 0（关）或 1（开）</translation>
        </message>
        <message>
            <source>P of an arc counts its turns</source>
            <translation>圆弧的 P 是圈数</translation>
        </message>
        <message>
            <source>POSITIONING</source>
            <translation>定位中</translation>
        </message>
        <message>
            <source>PROGRAM</source>
            <translation>程序</translation>
        </message>
        <message>
            <source>Page faults, preemptions of the tick</source>
            <translation>节拍的缺页和被抢占次数</translation>
        </message>
        <message>
            <source>Panels in frames of their own</source>
            <translation>面板独立成窗</translation>
        </message>
        <message>
            <source>Part of the next command</source>
            <translation>下一命令的一部分</translation>
        </message>
        <message>
            <source>Parts of the profile</source>
            <translation>配置的各部分</translation>
        </message>
        <message>
            <source>Pass</source>
            <translation>走刀</translation>
        </message>
        <message>
            <source>Pause</source>
            <translation>暂停</translation>
        </message>
        <message>
            <source>Period of the core's base tick; pins change only at ticks.</source>
            <translation>内核基本节拍的周期；引脚只在节拍处变化。</translation>
        </message>
        <message>
            <source>Pictures (%1)</source>
            <translation>图片 (%1)</translation>
        </message>
        <message>
            <source>Pictures (*.png)</source>
            <translation>图片 (*.png)</translation>
        </message>
        <message>
            <source>Pin</source>
            <translation>引脚</translation>
        </message>
        <message>
            <source>Pins recorded: %1</source>
            <translation>引脚已记录：%1</translation>
        </message>
        <message>
            <source>Placement and slicing</source>
            <translation>摆放与切片</translation>
        </message>
        <message>
            <source>Planned time</source>
            <translation>计划时间</translation>
        </message>
        <message>
            <source>Planner angle: directions that differ by less belong to one segment.</source>
            <translation>planner angle：方向差小于此值的归为一段。</translation>
        </message>
        <message>
            <source>Planning fell behind the motion: free the computer of other work or lower the feed; reset the alarm, then start again.</source>
            <translation>规划落后于运动：减少计算机的其他工作或降低进给；复位报警，然后重新启动。</translation>
        </message>
        <message>
            <source>Play</source>
            <translation>播放</translation>
        </message>
        <message>
            <source>Play or pause (K)</source>
            <translation>播放或暂停 (K)</translation>
        </message>
        <message>
            <source>Play that a reversal takes up before the axis moves.</source>
            <translation>换向后轴移动前要走完的间隙。</translation>
        </message>
        <message>
            <source>Play that a reversal takes up before the table turns.</source>
            <translation>换向后转台转动前要走完的间隙。</translation>
        </message>
        <message>
            <source>Point</source>
            <translation>点</translation>
        </message>
        <message>
            <source>Point %1</source>
            <translation>点 %1</translation>
        </message>
        <message>
            <source>Point of that layer to start from</source>
            <translation>该层的起始点</translation>
        </message>
        <message>
            <source>Point, Ψ</source>
            <translation>点，Ψ</translation>
        </message>
        <message>
            <source>Points / head</source>
            <translation>点数 / 刀头</translation>
        </message>
        <message>
            <source>Points visited</source>
            <translation>到达的点</translation>
        </message>
        <message>
            <source>Port pins</source>
            <translation>端口引脚</translation>
        </message>
        <message>
            <source>Port timing</source>
            <translation>端口时序</translation>
        </message>
        <message>
            <source>Ports</source>
            <translation>端口</translation>
        </message>
        <message>
            <source>Position</source>
            <translation>位置</translation>
        </message>
        <message>
            <source>Position at the index.</source>
            <translation>零位处的位置。</translation>
        </message>
        <message>
            <source>Position at the sensor's edge.</source>
            <translation>传感器边沿处的位置。</translation>
        </message>
        <message>
            <source>Position not certain any more</source>
            <translation>位置不再确定</translation>
        </message>
        <message>
            <source>Position of %1</source>
            <translation>%1 的位置</translation>
        </message>
        <message>
            <source>Positioning keeps the heads this far outside the blank.</source>
            <translation>定位时刀头与毛坯保持的距离。</translation>
        </message>
        <message>
            <source>Positions are lost; home again afterwards</source>
            <translation>位置将丢失；之后请重新回零</translation>
        </message>
        <message>
            <source>Pre-flight</source>
            <translation>启动前检查</translation>
        </message>
        <message>
            <source>Present positions</source>
            <translation>当前位置</translation>
        </message>
        <message>
            <source>Probable unit</source>
            <translation>可能的单位</translation>
        </message>
        <message>
            <source>Processor</source>
            <translation>处理器</translation>
        </message>
        <message>
            <source>Processor of the tick</source>
            <translation>节拍的处理器</translation>
        </message>
        <message>
            <source>Profile</source>
            <translation>配置</translation>
        </message>
        <message>
            <source>Profile %1 of --profile is not the machine's, which counts by another one</source>
            <translation>--profile 的配置 %1 不是机床的配置，机床按另一个配置计数</translation>
        </message>
        <message>
            <source>Profile %1 of --profile is not the machine's, which counts by its own, %2</source>
            <translation>--profile 的配置 %1 不是机床的配置，机床按自己的配置 %2 计数</translation>
        </message>
        <message>
            <source>Profile matches job</source>
            <translation>配置与作业相符</translation>
        </message>
        <message>
            <source>Profile not saved</source>
            <translation>配置未保存</translation>
        </message>
        <message>
            <source>Profile saved: %1</source>
            <translation>配置已保存：%1</translation>
        </message>
        <message>
            <source>Profile, log, snapshot of job and status, versions: for whoever helps</source>
            <translation>配置、日志、作业与状态快照、版本：供协助者使用</translation>
        </message>
        <message>
            <source>Profiles (*.toml)</source>
            <translation>配置 (*.toml)</translation>
        </message>
        <message>
            <source>Program</source>
            <translation>程序</translation>
        </message>
        <message>
            <source>Program begun</source>
            <translation>程序已开始</translation>
        </message>
        <message>
            <source>Program broke off behind line %1</source>
            <translation>程序在第 %1 行之后中断</translation>
        </message>
        <message>
            <source>Program done, up to line %1</source>
            <translation>程序已完成，至第 %1 行</translation>
        </message>
        <message>
            <source>Program ended</source>
            <translation>程序结束</translation>
        </message>
        <message>
            <source>Program ended by an alarm in line %1</source>
            <translation>程序在第 %1 行因报警结束</translation>
        </message>
        <message>
            <source>Program ended in line %1</source>
            <translation>程序在第 %1 行结束</translation>
        </message>
        <message>
            <source>Program goes on in line %1</source>
            <translation>程序在第 %1 行继续</translation>
        </message>
        <message>
            <source>Program held in line %1</source>
            <translation>程序在第 %1 行暂停</translation>
        </message>
        <message>
            <source>Program run</source>
            <translation>程序已运行</translation>
        </message>
        <message>
            <source>Program slows down to a stop in line %1</source>
            <translation>程序在第 %1 行减速停止</translation>
        </message>
        <message>
            <source>Program started: %1</source>
            <translation>程序已启动：%1</translation>
        </message>
        <message>
            <source>Program stopped in line %1</source>
            <translation>程序在第 %1 行停止</translation>
        </message>
        <message>
            <source>Program, before its first line</source>
            <translation>程序，在第一行之前</translation>
        </message>
        <message>
            <source>Program, line %1</source>
            <translation>程序，第 %1 行</translation>
        </message>
        <message>
            <source>Programs in G-code (%1)</source>
            <translation>G 代码程序 (%1)</translation>
        </message>
        <message>
            <source>Progress</source>
            <translation>进度</translation>
        </message>
        <message>
            <source>Publish</source>
            <translation>发布</translation>
        </message>
        <message>
            <source>Publish: a job is being made</source>
            <translation>发布：正在生成作业</translation>
        </message>
        <message>
            <source>Publish: the machine is busy</source>
            <translation>发布：机床忙</translation>
        </message>
        <message>
            <source>Publish: there is no job; slice the model first</source>
            <translation>发布：没有作业；请先切片模型</translation>
        </message>
        <message>
            <source>Publish: this job is published</source>
            <translation>发布：此作业已发布</translation>
        </message>
        <message>
            <source>Publishing …</source>
            <translation>正在发布 …</translation>
        </message>
        <message>
            <source>Pull-in speed: what the motor may jump to from rest (j_k).</source>
            <translation>启动速度：电机可从静止直接跳到的速度（j_k）。</translation>
        </message>
        <message>
            <source>Pulses in a second</source>
            <translation>每秒脉冲数</translation>
        </message>
        <message>
            <source>Pulses of %1</source>
            <translation>%1 的脉冲</translation>
        </message>
        <message>
            <source>Pulses of %1, with the ways in and out</source>
            <translation>%1 的脉冲（含进刀和退刀）</translation>
        </message>
        <message>
            <source>Pulses per second R1, R2, Ψ, Y</source>
            <translation>每秒脉冲 R1、R2、Ψ、Y</translation>
        </message>
        <message>
            <source>Pulses since start</source>
            <translation>启动后脉冲</translation>
        </message>
        <message>
            <source>Pulses to go</source>
            <translation>剩余脉冲</translation>
        </message>
        <message>
            <source>Pump</source>
            <translation>电荷泵</translation>
        </message>
        <message>
            <source>Puts this job on the desk</source>
            <translation>把此作业取到窗口中</translation>
        </message>
        <message>
            <source>Puts this job on the desk in place of %1</source>
            <translation>把此作业取到窗口中，代替 %1</translation>
        </message>
        <message>
            <source>Q of G64 is not used: the tolerance of P holds for all</source>
            <translation>G64 的 Q 不使用：P 的公差适用于全部</translation>
        </message>
        <message>
            <source>R is below the depth of the hole</source>
            <translation>R 低于孔底</translation>
        </message>
        <message>
            <source>R1 %1 mm</source>
            <translation>R1 %1 mm</translation>
        </message>
        <message>
            <source>R1 %1 · R2 %2 · Y %3 mm · Ψ %4°</source>
            <translation>R1 %1 · R2 %2 · Y %3 mm · Ψ %4°</translation>
        </message>
        <message>
            <source>R1 / mm, Y upwards / mm</source>
            <translation>R1 / mm，Y 向上 / mm</translation>
        </message>
        <message>
            <source>R1 and R2 out, then Y, then Ψ to its index (Ctrl+Home)</source>
            <translation>先 R1 和 R2 退出，再 Y，然后 Ψ 到零位（Ctrl+Home）</translation>
        </message>
        <message>
            <source>R1 direction</source>
            <translation>R1 方向</translation>
        </message>
        <message>
            <source>R1 enable</source>
            <translation>R1 使能</translation>
        </message>
        <message>
            <source>R1 half</source>
            <translation>R1 半周</translation>
        </message>
        <message>
            <source>R1 in</source>
            <translation>R1 进</translation>
        </message>
        <message>
            <source>R1 limit</source>
            <translation>R1 限位</translation>
        </message>
        <message>
            <source>R1 out</source>
            <translation>R1 退</translation>
        </message>
        <message>
            <source>R1 plane</source>
            <translation>R1 平面</translation>
        </message>
        <message>
            <source>R1 step</source>
            <translation>R1 步进</translation>
        </message>
        <message>
            <source>R2 %1 mm</source>
            <translation>R2 %1 mm</translation>
        </message>
        <message>
            <source>R2 / mm, Y upwards / mm</source>
            <translation>R2 / mm，Y 向上 / mm</translation>
        </message>
        <message>
            <source>R2 direction</source>
            <translation>R2 方向</translation>
        </message>
        <message>
            <source>R2 enable</source>
            <translation>R2 使能</translation>
        </message>
        <message>
            <source>R2 follows R1 (profile: gcode.second_head), and they stand at different radii; bring them to one radius</source>
            <translation>R2 跟随 R1（配置：gcode.second_head），但两者半径不同；请移到同一半径</translation>
        </message>
        <message>
            <source>R2 half</source>
            <translation>R2 半周</translation>
        </message>
        <message>
            <source>R2 has a letter of its own, or goes where the letter of R1 says.</source>
            <translation>R2 有自己的字母，或跟随 R1 的字母移动。</translation>
        </message>
        <message>
            <source>R2 in</source>
            <translation>R2 进</translation>
        </message>
        <message>
            <source>R2 limit</source>
            <translation>R2 限位</translation>
        </message>
        <message>
            <source>R2 out</source>
            <translation>R2 退</translation>
        </message>
        <message>
            <source>R2 plane</source>
            <translation>R2 平面</translation>
        </message>
        <message>
            <source>R2 stands %1 mm lower than R1 and is under the model in %2 of its layers: there it cuts what holds the model down to a radius of %3 mm.</source>
            <translation>R2 比 R1 低 %1 mm，有 %2 层位于模型下方：它会在那里把支撑模型的部分切到半径 %3 mm。</translation>
        </message>
        <message>
            <source>R2 step</source>
            <translation>R2 步进</translation>
        </message>
        <message>
            <source>R2's height error draws the rows up to %1 mm apart, but the tool is only %2 mm wide: between them material stays, as high as the blank; zigzag joining avoids it.</source>
            <translation>R2 的高度误差使各行相距达 %1 mm，而刀具宽仅 %2 mm：行间会留下与毛坯等高的材料；改用往复连接可避免。</translation>
        </message>
        <message>
            <source>R2's height error makes the rows uneven: up to %1 mm apart instead of %2 mm; zigzag joining avoids it.</source>
            <translation>R2 的高度误差使各行间距不均：最大相距 %1 mm，而不是 %2 mm；改用往复连接可避免。</translation>
        </message>
        <message>
            <source>READY</source>
            <translation>就绪</translation>
        </message>
        <message>
            <source>REPLAY</source>
            <translation>回放</translation>
        </message>
        <message>
            <source>REPLAY: %1</source>
            <translation>回放：%1</translation>
        </message>
        <message>
            <source>Radii</source>
            <translation>半径</translation>
        </message>
        <message>
            <source>Radius</source>
            <translation>半径</translation>
        </message>
        <message>
            <source>Radius along layer %1, mm over Ψ</source>
            <translation>第 %1 层的半径（mm，沿 Ψ）</translation>
        </message>
        <message>
            <source>Radius along the layer, both heads</source>
            <translation>沿层的半径，两个刀头</translation>
        </message>
        <message>
            <source>Radius of the cylinder that is carved, which the heads keep out of; 0: the job's largest.</source>
            <translation>被雕刻圆柱的半径，刀头在其外移动；0：取任务中的最大半径。</translation>
        </message>
        <message>
            <source>Rapids</source>
            <translation>快速</translation>
        </message>
        <message>
            <source>Read off the pins: a trace has no flight recorder. A click goes to an entry.</source>
            <translation>由引脚读出：轨迹中没有飞行记录。单击转到该条。</translation>
        </message>
        <message>
            <source>Reading the file …</source>
            <translation>正在读取文件 …</translation>
        </message>
        <message>
            <source>Reading the program: %1 %</source>
            <translation>正在读取程序：%1 %</translation>
        </message>
        <message>
            <source>Reading the recording</source>
            <translation>读取记录</translation>
        </message>
        <message>
            <source>Reads and judges the file once more, by the machine as it is now</source>
            <translation>按机床当前状态重新读取并检查文件</translation>
        </message>
        <message>
            <source>Real time</source>
            <translation>实时</translation>
        </message>
        <message>
            <source>Real-time rights</source>
            <translation>实时权限</translation>
        </message>
        <message>
            <source>Record pins</source>
            <translation>记录引脚</translation>
        </message>
        <message>
            <source>Record pins: begin it while the machine is at rest</source>
            <translation>记录引脚：请在机床静止时开始</translation>
        </message>
        <message>
            <source>Record pins: publish a job first</source>
            <translation>记录引脚：请先发布任务</translation>
        </message>
        <message>
            <source>Record pins: the last recording is being written</source>
            <translation>记录引脚：上一次记录正在写入</translation>
        </message>
        <message>
            <source>Record pins…</source>
            <translation>记录引脚…</translation>
        </message>
        <message>
            <source>Recorded levels at the entries of the flight recorder. Steps are not in a snapshot.</source>
            <translation>飞行记录各条时的电平。快照中没有步进。</translation>
        </message>
        <message>
            <source>Recorded levels of the 20 seconds before this moment.</source>
            <translation>此刻之前 20 秒的记录电平。</translation>
        </message>
        <message>
            <source>Recording the pins: %1</source>
            <translation>正在记录引脚：%1</translation>
        </message>
        <message>
            <source>Recordings (%1)</source>
            <translation>记录 (%1)</translation>
        </message>
        <message>
            <source>Reference time (T_ref)</source>
            <translation>参考时间 (T_ref)</translation>
        </message>
        <message>
            <source>Refused: %1</source>
            <translation>已拒绝：%1</translation>
        </message>
        <message>
            <source>Register bit</source>
            <translation>寄存器位</translation>
        </message>
        <message>
            <source>Release the emergency stop once the machine is safe, reset the alarm, then home.</source>
            <translation>机床安全后松开急停，复位报警，然后回零。</translation>
        </message>
        <message>
            <source>Release the emergency stop switch</source>
            <translation>松开急停开关</translation>
        </message>
        <message>
            <source>Reload</source>
            <translation>重新载入</translation>
        </message>
        <message>
            <source>Removed %1 cm³</source>
            <translation>去除 %1 cm³</translation>
        </message>
        <message>
            <source>Replay moves nothing: leave replay first</source>
            <translation>回放不驱动机床：请先退出回放</translation>
        </message>
        <message>
            <source>Replay: %1, %2 recorded</source>
            <translation>回放：%1，已记录 %2</translation>
        </message>
        <message>
            <source>Replay: the piece cannot be shown</source>
            <translation>回放：无法显示工件</translation>
        </message>
        <message>
            <source>Replay: the piece is too large to be shown to its end</source>
            <translation>回放：工件过大，无法显示到结尾</translation>
        </message>
        <message>
            <source>Report</source>
            <translation>报告</translation>
        </message>
        <message>
            <source>Report on the model</source>
            <translation>模型报告</translation>
        </message>
        <message>
            <source>Report: no job was started</source>
            <translation>报告：尚未启动作业</translation>
        </message>
        <message>
            <source>Report: open a model first</source>
            <translation>报告：请先打开模型</translation>
        </message>
        <message>
            <source>Report: the job is not known</source>
            <translation>报告：作业未知</translation>
        </message>
        <message>
            <source>Report…</source>
            <translation>报告…</translation>
        </message>
        <message>
            <source>Reset alarm</source>
            <translation>复位报警</translation>
        </message>
        <message>
            <source>Reset alarm: an axis backs off its switch</source>
            <translation>复位报警：有轴正在退离开关</translation>
        </message>
        <message>
            <source>Reset alarm: there is no alarm</source>
            <translation>复位报警：没有报警</translation>
        </message>
        <message>
            <source>Reset layout</source>
            <translation>恢复布局</translation>
        </message>
        <message>
            <source>Reset the alarm, then home.</source>
            <translation>复位报警，然后回零。</translation>
        </message>
        <message>
            <source>Restore backup</source>
            <translation>恢复备份</translation>
        </message>
        <message>
            <source>Restore backup: the built-in profile has no file</source>
            <translation>恢复备份：内置配置没有文件</translation>
        </message>
        <message>
            <source>Restore backup: this file has none yet</source>
            <translation>恢复备份：此文件还没有备份</translation>
        </message>
        <message>
            <source>Result</source>
            <translation>结果</translation>
        </message>
        <message>
            <source>Resume</source>
            <translation>继续</translation>
        </message>
        <message>
            <source>Resume: not on hold</source>
            <translation>继续：未暂停</translation>
        </message>
        <message>
            <source>Resume: nothing is left of the program; stop</source>
            <translation>继续：程序已无剩余内容；请停止</translation>
        </message>
        <message>
            <source>Resume: the program goes on by itself when more of it comes</source>
            <translation>继续：后续内容到达后程序会自行继续</translation>
        </message>
        <message>
            <source>Roughing</source>
            <translation>粗加工</translation>
        </message>
        <message>
            <source>Roughing cannot keep its stepover of %1 mm: the job's layers lie %2 mm apart.</source>
            <translation>粗加工无法保持 %1 mm 的步距：作业各层相距 %2 mm。</translation>
        </message>
        <message>
            <source>Run a program in G-code…</source>
            <translation>运行 G 代码程序…</translation>
        </message>
        <message>
            <source>Run before: to layer %1 (From layer %2).</source>
            <translation>上一次：到第 %1 层（“从层”%2）。</translation>
        </message>
        <message>
            <source>Run from line %1: first the machine does this</source>
            <translation>从第 %1 行运行：机床首先这样做</translation>
        </message>
        <message>
            <source>Runs it as a process of its own: closing this window ends nothing</source>
            <translation>作为独立进程运行：关闭此窗口不会结束任何东西</translation>
        </message>
        <message>
            <source>Runs the core's own tick loop with nothing in the tick; touches no machine</source>
            <translation>运行内核自身的空节拍循环；不接触机床</translation>
        </message>
        <message>
            <source>S: the machine's spindle is only switched</source>
            <translation>S：机床主轴只能开关</translation>
        </message>
        <message>
            <source>SCHED_FIFO, priority %1</source>
            <translation>SCHED_FIFO，优先级 %1</translation>
        </message>
        <message>
            <source>SIMULATOR</source>
            <translation>仿真</translation>
        </message>
        <message>
            <source>SQRT of a value below 0</source>
            <translation>SQRT 的自变量小于 0</translation>
        </message>
        <message>
            <source>STOPPING</source>
            <translation>停止中</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>保存</translation>
        </message>
        <message>
            <source>Save CSV: nothing was measured yet</source>
            <translation>保存 CSV：还没有测量结果</translation>
        </message>
        <message>
            <source>Save CSV…</source>
            <translation>保存 CSV…</translation>
        </message>
        <message>
            <source>Save a snapshot</source>
            <translation>保存快照</translation>
        </message>
        <message>
            <source>Save a snapshot…</source>
            <translation>保存快照…</translation>
        </message>
        <message>
            <source>Save as JSON…</source>
            <translation>另存为 JSON…</translation>
        </message>
        <message>
            <source>Save as...</source>
            <translation>另存为...</translation>
        </message>
        <message>
            <source>Save its tables…</source>
            <translation>保存任务表…</translation>
        </message>
        <message>
            <source>Save log…</source>
            <translation>保存日志…</translation>
        </message>
        <message>
            <source>Save picture…</source>
            <translation>保存图片…</translation>
        </message>
        <message>
            <source>Save the job</source>
            <translation>保存任务</translation>
        </message>
        <message>
            <source>Save the job…</source>
            <translation>保存任务…</translation>
        </message>
        <message>
            <source>Save the log</source>
            <translation>保存日志</translation>
        </message>
        <message>
            <source>Save the measurement</source>
            <translation>保存测量结果</translation>
        </message>
        <message>
            <source>Save the picture</source>
            <translation>保存图片</translation>
        </message>
        <message>
            <source>Save the profile</source>
            <translation>保存配置</translation>
        </message>
        <message>
            <source>Save the profile as</source>
            <translation>配置另存为</translation>
        </message>
        <message>
            <source>Save the report</source>
            <translation>保存报告</translation>
        </message>
        <message>
            <source>Save the tables</source>
            <translation>保存任务表</translation>
        </message>
        <message>
            <source>Save: %1 values are wrong</source>
            <translation>保存：%1 个值有误</translation>
        </message>
        <message>
            <source>Save: nothing was changed</source>
            <translation>保存：没有任何更改</translation>
        </message>
        <message>
            <source>Save: one value is wrong</source>
            <translation>保存：一个值有误</translation>
        </message>
        <message>
            <source>Save: the built-in profile has no file; save it as one</source>
            <translation>保存：内置配置没有文件；请另存为文件</translation>
        </message>
        <message>
            <source>Save: the machine moves</source>
            <translation>保存：机床在运动</translation>
        </message>
        <message>
            <source>Saved as %1; open it once the machine is at rest</source>
            <translation>已保存为 %1；待机床静止后再打开</translation>
        </message>
        <message>
            <source>Saved: %1</source>
            <translation>已保存：%1</translation>
        </message>
        <message>
            <source>Saving…</source>
            <translation>正在保存…</translation>
        </message>
        <message>
            <source>Scale</source>
            <translation>比例</translation>
        </message>
        <message>
            <source>Scale %1</source>
            <translation>比例 %1</translation>
        </message>
        <message>
            <source>Scale sets it</source>
            <translation>由比例决定</translation>
        </message>
        <message>
            <source>Scales the drawing to go all round</source>
            <translation>缩放图形使其绕满一周</translation>
        </message>
        <message>
            <source>Scales the model, uniformly</source>
            <translation>等比缩放模型</translation>
        </message>
        <message>
            <source>Schedule two-timer: period of inputs and pulses, at most one pulse in each.</source>
            <translation>two-timer 方案：输入与脉冲的周期，每周期至多一个脉冲。</translation>
        </message>
        <message>
            <source>Schedule two-timer: period of the interpolation.</source>
            <translation>two-timer 方案：插补周期。</translation>
        </message>
        <message>
            <source>Seam</source>
            <translation>接缝</translation>
        </message>
        <message>
            <source>Search</source>
            <translation>搜索</translation>
        </message>
        <message>
            <source>Search the messages</source>
            <translation>搜索消息</translation>
        </message>
        <message>
            <source>Second snapshot or job</source>
            <translation>第二个快照或作业</translation>
        </message>
        <message>
            <source>Section at Y %1 mm, radius in mm</source>
            <translation>Y %1 mm 处的截面，半径单位 mm</translation>
        </message>
        <message>
            <source>Section of the layer, seen from above</source>
            <translation>层截面，俯视</translation>
        </message>
        <message>
            <source>See how far the piece is carved before it goes on.</source>
            <translation>继续之前，请查看工件雕到了哪里。</translation>
        </message>
        <message>
            <source>See to the port's card, cable and driver</source>
            <translation>检查端口的板卡、电缆和驱动程序</translation>
        </message>
        <message>
            <source>Select axis %1</source>
            <translation>选择轴 %1</translation>
        </message>
        <message>
            <source>Send pulses</source>
            <translation>发送脉冲</translation>
        </message>
        <message>
            <source>Settings are not kept</source>
            <translation>设置未保存</translation>
        </message>
        <message>
            <source>Shape vee: between the flanks.</source>
            <translation>形状 vee：两侧面之间的夹角。</translation>
        </message>
        <message>
            <source>Show</source>
            <translation>显示</translation>
        </message>
        <message>
            <source>Show in the flight recorder</source>
            <translation>在飞行记录中显示</translation>
        </message>
        <message>
            <source>Shows how far %1 is from here; no motion changes</source>
            <translation>显示 %1 离此处的距离；不影响任何运动</translation>
        </message>
        <message>
            <source>Shows only what differs from the built-in profile</source>
            <translation>只显示与内置配置不同之处</translation>
        </message>
        <message>
            <source>Shows only what differs from the file, and would be saved</source>
            <translation>只显示与文件不同、将要保存的值</translation>
        </message>
        <message>
            <source>Side</source>
            <translation>侧</translation>
        </message>
        <message>
            <source>Signal</source>
            <translation>信号</translation>
        </message>
        <message>
            <source>Silent at work</source>
            <translation>工作中无响应</translation>
        </message>
        <message>
            <source>Since %1, tool %2.</source>
            <translation>时间 %1，刀具 %2。</translation>
        </message>
        <message>
            <source>Since %1.</source>
            <translation>时间 %1。</translation>
        </message>
        <message>
            <source>Since the start</source>
            <translation>自打开以来</translation>
        </message>
        <message>
            <source>Since then the core has ended: there is none to take orders.</source>
            <translation>此后内核已结束：没有内核接收指令。</translation>
        </message>
        <message>
            <source>Since then the core is silent: it takes no orders.</source>
            <translation>此后内核无响应：不接收指令。</translation>
        </message>
        <message>
            <source>Since when, and with which tool, is not known: no disk tells of it.</source>
            <translation>从何时开始、用何刀具未知：没有磁盘记录它。</translation>
        </message>
        <message>
            <source>Since when, and with which tool, is not known: the disk tells of another piece or layer by now.</source>
            <translation>自何时起、用哪把刀具不得而知：磁盘现在记录的是另一个工件或另一层。</translation>
        </message>
        <message>
            <source>Single block</source>
            <translation>单段</translation>
        </message>
        <message>
            <source>Single block off</source>
            <translation>单段关</translation>
        </message>
        <message>
            <source>Single block on</source>
            <translation>单段开</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>尺寸</translation>
        </message>
        <message>
            <source>Slice</source>
            <translation>切片</translation>
        </message>
        <message>
            <source>Slice: a job is being made</source>
            <translation>切片：正在生成作业</translation>
        </message>
        <message>
            <source>Slice: open a model first</source>
            <translation>切片：请先打开模型</translation>
        </message>
        <message>
            <source>Slice: this is a job, and already sliced</source>
            <translation>切片：这是作业，已经切片</translation>
        </message>
        <message>
            <source>Slicing …</source>
            <translation>正在切片 …</translation>
        </message>
        <message>
            <source>Slows down along the path and stands on it (Pause, Esc)</source>
            <translation>沿路径减速并停在路径上（Pause、Esc）</translation>
        </message>
        <message>
            <source>Smoothed over so far, mm</source>
            <translation>平滑范围，mm</translation>
        </message>
        <message>
            <source>Snapshots (*.snap)</source>
            <translation>快照 (*.snap)</translation>
        </message>
        <message>
            <source>Snapshots and jobs (*.snap *.job *.psi);;All files (*)</source>
            <translation>快照和作业 (*.snap *.job *.psi);;所有文件 (*)</translation>
        </message>
        <message>
            <source>Some facets are flipped against their neighbours; carved as if they were not.</source>
            <translation>有些面与相邻面朝向相反；按朝向正确雕刻。</translation>
        </message>
        <message>
            <source>Sound at an alarm</source>
            <translation>报警时发声</translation>
        </message>
        <message>
            <source>Source size</source>
            <translation>模型大小</translation>
        </message>
        <message>
            <source>Speed</source>
            <translation>速度</translation>
        </message>
        <message>
            <source>Speed %1 (J slower, L faster)</source>
            <translation>速度 %1（J 更慢，L 更快）</translation>
        </message>
        <message>
            <source>Speed of homing and of backing off.</source>
            <translation>回零和退离的速度。</translation>
        </message>
        <message>
            <source>Speed of homing.</source>
            <translation>回零速度。</translation>
        </message>
        <message>
            <source>Spindle</source>
            <translation>主轴</translation>
        </message>
        <message>
            <source>Spindle off</source>
            <translation>主轴关</translation>
        </message>
        <message>
            <source>Spindle off, heads outside the blank; table and Y go as they would</source>
            <translation>主轴关闭，刀头在毛坯外；转台和 Y 照常运动</translation>
        </message>
        <message>
            <source>Spindle off. Put a pin of known diameter on the axis, home, and bring %1 to it with the Jog panel, the last steps by hundredths, until the tip just touches: a slip of paper is held.</source>
            <translation>主轴关闭。在轴线上放一根已知直径的销，回零，用点动面板将 %1 移向它，最后按百分之一毫米移动，直到刀尖刚好接触：纸条被夹住。</translation>
        </message>
        <message>
            <source>Spindle on</source>
            <translation>主轴开</translation>
        </message>
        <message>
            <source>Spindle on or off</source>
            <translation>主轴开或关</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>启动</translation>
        </message>
        <message>
            <source>Start anew</source>
            <translation>重新开始</translation>
        </message>
        <message>
            <source>Start anew…</source>
            <translation>重新开始…</translation>
        </message>
        <message>
            <source>Start dry run</source>
            <translation>启动空运行</translation>
        </message>
        <message>
            <source>Start dry run from layer %1</source>
            <translation>从第 %1 层启动空运行</translation>
        </message>
        <message>
            <source>Start dry run from layer %1, point %2</source>
            <translation>从第 %1 层第 %2 点启动空运行</translation>
        </message>
        <message>
            <source>Start dry run from layer 1</source>
            <translation>从第 1 层启动空运行</translation>
        </message>
        <message>
            <source>Start from layer %1</source>
            <translation>从第 %1 层启动</translation>
        </message>
        <message>
            <source>Start from layer %1, point %2</source>
            <translation>从第 %1 层第 %2 点启动</translation>
        </message>
        <message>
            <source>Start from layer %1, point %2: what comes before it is left as it is. The heads go in at that very point, at plunge speed.</source>
            <translation>从第 %1 层第 %2 点启动：之前的部分保持原样。刀头就在这一点以切入速度进给。</translation>
        </message>
        <message>
            <source>Start from layer %1: the layers below are left as they are. The heads go out, Y goes to the layer, then the heads go in at plunge speed.</source>
            <translation>从第 %1 层启动：下面的层保持原样。刀头先退出，Y 移到该层，然后刀头以切入速度进给。</translation>
        </message>
        <message>
            <source>Start from layer 1</source>
            <translation>从第 1 层启动</translation>
        </message>
        <message>
            <source>Start it again; home before carving on</source>
            <translation>重新启动它；继续雕刻前先回零</translation>
        </message>
        <message>
            <source>Start program</source>
            <translation>启动程序</translation>
        </message>
        <message>
            <source>Start psicarve-rtcore</source>
            <translation>启动 psicarve-rtcore</translation>
        </message>
        <message>
            <source>Start psicarve-rtcore with that profile, or the window without it</source>
            <translation>请用该配置启动 psicarve-rtcore，或不带该配置启动窗口</translation>
        </message>
        <message>
            <source>Start spindle</source>
            <translation>启动主轴</translation>
        </message>
        <message>
            <source>Start, One layer and From layer carve nothing: table and Y go as they would, heads outside the blank, spindle off</source>
            <translation>启动、一层和从层均不雕刻：转台和 Y 按作业运动，刀头在毛坯外，主轴关闭</translation>
        </message>
        <message>
            <source>Start: a dry run switches nothing; switch the spindle off first</source>
            <translation>启动：空运行不切换任何输出；请先关闭主轴</translation>
        </message>
        <message>
            <source>Start: a job is being made</source>
            <translation>启动：正在生成作业</translation>
        </message>
        <message>
            <source>Start: a program runs</source>
            <translation>启动：程序正在运行</translation>
        </message>
        <message>
            <source>Start: a recording is shown; leave replay first</source>
            <translation>启动：正在显示记录；请先退出回放</translation>
        </message>
        <message>
            <source>Start: already carving</source>
            <translation>启动：已在雕刻</translation>
        </message>
        <message>
            <source>Start: an output is tested</source>
            <translation>启动：正在测试输出</translation>
        </message>
        <message>
            <source>Start: another program runs; stop it first</source>
            <translation>启动：另一程序正在运行；请先停止它</translation>
        </message>
        <message>
            <source>Start: axis %1 is not homed</source>
            <translation>启动：轴 %1 未回零</translation>
        </message>
        <message>
            <source>Start: errors in the program: %1</source>
            <translation>启动：程序中的错误：%1</translation>
        </message>
        <message>
            <source>Start: it was judged for another profile; decode it again</source>
            <translation>启动：它是按另一配置检查的；请重新解析</translation>
        </message>
        <message>
            <source>Start: it was read with another block delete; decode it again</source>
            <translation>启动：读取时“跳过程序段”设置不同；请重新解析</translation>
        </message>
        <message>
            <source>Start: no job is published</source>
            <translation>启动：没有已发布的作业</translation>
        </message>
        <message>
            <source>Start: no layer was finished</source>
            <translation>启动：没有完成的层</translation>
        </message>
        <message>
            <source>Start: no program is open</source>
            <translation>启动：没有打开程序</translation>
        </message>
        <message>
            <source>Start: on hold; only Stop is left</source>
            <translation>启动：已暂停；只能停止</translation>
        </message>
        <message>
            <source>Start: on hold; resume or stop</source>
            <translation>启动：已暂停；请继续或停止</translation>
        </message>
        <message>
            <source>Start: pre-flight, %1: %2</source>
            <translation>启动：启动前检查，%1：%2</translation>
        </message>
        <message>
            <source>Start: reset the alarm first</source>
            <translation>启动：请先复位报警</translation>
        </message>
        <message>
            <source>Start: slice the model, then publish the job</source>
            <translation>启动：先切片模型，再发布作业</translation>
        </message>
        <message>
            <source>Start: stopping</source>
            <translation>启动：正在停止</translation>
        </message>
        <message>
            <source>Start: the core's profile is not known; open it on page Profile</source>
            <translation>启动：核心的配置未知；请在“配置”页打开它</translation>
        </message>
        <message>
            <source>Start: the drives are off; home all axes</source>
            <translation>启动：驱动已关闭；请全部回零</translation>
        </message>
        <message>
            <source>Start: the file has been changed since it was read; decode it again</source>
            <translation>启动：文件在读取后已更改；请重新解析</translation>
        </message>
        <message>
            <source>Start: the heads are on their way</source>
            <translation>启动：刀头正在移动就位</translation>
        </message>
        <message>
            <source>Start: the heads are on their way out</source>
            <translation>启动：刀头正在退出</translation>
        </message>
        <message>
            <source>Start: the heads wait at the first point of a job; stop first</source>
            <translation>启动：刀头在作业的第一点等待；请先停止</translation>
        </message>
        <message>
            <source>Start: the job is being published</source>
            <translation>启动：作业正在发布</translation>
        </message>
        <message>
            <source>Start: the job is not published</source>
            <translation>启动：作业未发布</translation>
        </message>
        <message>
            <source>Start: the machine moves</source>
            <translation>启动：机床在运动</translation>
        </message>
        <message>
            <source>Start: the program ends in line %1</source>
            <translation>启动：程序在第 %1 行结束</translation>
        </message>
        <message>
            <source>Start: the program is being read</source>
            <translation>启动：正在读取程序</translation>
        </message>
        <message>
            <source>Start: the program is on its way</source>
            <translation>启动：程序正在送出</translation>
        </message>
        <message>
            <source>State at the end</source>
            <translation>结束状态</translation>
        </message>
        <message>
            <source>States</source>
            <translation>状态</translation>
        </message>
        <message>
            <source>Step %1 %2</source>
            <translation>步长 %1 %2</translation>
        </message>
        <message>
            <source>Stepdown</source>
            <translation>下切步距</translation>
        </message>
        <message>
            <source>Stepover</source>
            <translation>层距</translation>
        </message>
        <message>
            <source>Still open: %1</source>
            <translation>仍打开着：%1</translation>
        </message>
        <message>
            <source>Stop</source>
            <translation>停止</translation>
        </message>
        <message>
            <source>Stop asked for</source>
            <translation>已请求停止</translation>
        </message>
        <message>
            <source>Stop recording</source>
            <translation>停止记录</translation>
        </message>
        <message>
            <source>Stop spindle</source>
            <translation>停止主轴</translation>
        </message>
        <message>
            <source>Stop: all axes are at rest</source>
            <translation>停止：各轴均静止</translation>
        </message>
        <message>
            <source>Stop: already stopping</source>
            <translation>停止：已在停止</translation>
        </message>
        <message>
            <source>Stop: nothing is moving</source>
            <translation>停止：没有运动</translation>
        </message>
        <message>
            <source>Stroke widths</source>
            <translation>按线宽</translation>
        </message>
        <message>
            <source>Support bundle: %1</source>
            <translation>支持包：%1</translation>
        </message>
        <message>
            <source>Support bundle…</source>
            <translation>支持包…</translation>
        </message>
        <message>
            <source>Surface</source>
            <translation>表面</translation>
        </message>
        <message>
            <source>Surface closed, all facets turned alike</source>
            <translation>表面封闭，所有面朝向一致</translation>
        </message>
        <message>
            <source>Surface that no tip reached</source>
            <translation>刀尖未到达的表面</translation>
        </message>
        <message>
            <source>Switch %1 is still closed</source>
            <translation>开关 %1 仍闭合</translation>
        </message>
        <message>
            <source>Switch the machine off by its own switch</source>
            <translation>用机床自身的开关关断机床</translation>
        </message>
        <message>
            <source>Switched off: %1</source>
            <translation>已断开：%1</translation>
        </message>
        <message>
            <source>Switched on: %1</source>
            <translation>已接通：%1</translation>
        </message>
        <message>
            <source>Switches one output at a time. Home again afterwards.</source>
            <translation>一次切换一个输出。之后请重新回零。</translation>
        </message>
        <message>
            <source>TESTING</source>
            <translation>测试中</translation>
        </message>
        <message>
            <source>T_ref</source>
            <translation>T_ref</translation>
        </message>
        <message>
            <source>Table and Y go as they would, heads outside the blank, spindle off (Ctrl+Enter)</source>
            <translation>转台和 Y 按作业运动，刀头在毛坯外，主轴关闭（Ctrl+Enter）</translation>
        </message>
        <message>
            <source>Tables (%1)</source>
            <translation>表格 (%1)</translation>
        </message>
        <message>
            <source>Tables (*.csv *.json)</source>
            <translation>表格 (*.csv *.json)</translation>
        </message>
        <message>
            <source>Tables (*.csv)</source>
            <translation>表格 (*.csv)</translation>
        </message>
        <message>
            <source>Take over</source>
            <translation>取用</translation>
        </message>
        <message>
            <source>Take over: a job is being made</source>
            <translation>取用：正在生成作业</translation>
        </message>
        <message>
            <source>Take up again</source>
            <translation>取回</translation>
        </message>
        <message>
            <source>Take up again: %1, %2 layers × %3 points</source>
            <translation>取回：%1，%2 层 × %3 点</translation>
        </message>
        <message>
            <source>Take up again: %1, %2 layers × %3 points, sliced</source>
            <translation>取回：%1，%2 层 × %3 点，已切片</translation>
        </message>
        <message>
            <source>Taken over from the core: profile %1</source>
            <translation>已采用内核的配置 %1</translation>
        </message>
        <message>
            <source>Taken over from the machine: %1</source>
            <translation>已从机床取用：%1</translation>
        </message>
        <message>
            <source>Takes the position that the core counts now</source>
            <translation>取内核当前计数的位置</translation>
        </message>
        <message>
            <source>Takes this away once it was read; it moves and stops nothing</source>
            <translation>读后移除此消息；不移动也不停止任何东西</translation>
        </message>
        <message>
            <source>Takes this away until more is carved; it moves and forgets nothing</source>
            <translation>收起此条，直到又有雕刻；不移动也不忘记任何东西</translation>
        </message>
        <message>
            <source>Text (*.log *.txt)</source>
            <translation>文本 (*.log *.txt)</translation>
        </message>
        <message>
            <source>Text is left out: convert it to paths in the drawing program.</source>
            <translation>文字已略去：请在绘图软件中将其转换为路径。</translation>
        </message>
        <message>
            <source>The axis of the file that changes its sign, before the model is turned</source>
            <translation>在旋转模型之前，文件中改变符号的轴</translation>
        </message>
        <message>
            <source>The axis that is at its top speed or acceleration, else the feed</source>
            <translation>已达最高速度或加速度的轴，否则为进给</translation>
        </message>
        <message>
            <source>The backup is being read</source>
            <translation>正在读取备份</translation>
        </message>
        <message>
            <source>The blank as carved so far</source>
            <translation>目前雕刻到的毛坯</translation>
        </message>
        <message>
            <source>The blank reaches out to %1 mm, which is more than the heads can clear, %2 mm.</source>
            <translation>毛坯最远伸到 %1 mm，大于刀头能避开的 %2 mm。</translation>
        </message>
        <message>
            <source>The blank's radius of %1 mm is less than the model's, %2 mm.</source>
            <translation>毛坯半径 %1 mm 小于模型半径 %2 mm。</translation>
        </message>
        <message>
            <source>The blank's radius of %1 mm is more than the heads can clear, %2 mm.</source>
            <translation>毛坯半径 %1 mm 大于刀头能避开的 %2 mm。</translation>
        </message>
        <message>
            <source>The blank's top stands %1 mm above the table, the model's %2 mm.</source>
            <translation>毛坯顶面高出转台 %1 mm，模型顶面高出 %2 mm。</translation>
        </message>
        <message>
            <source>The blank, the passes' depths and the tool, to scale</source>
            <translation>毛坯、各道深度和刀具（按比例）</translation>
        </message>
        <message>
            <source>The block has %1 bytes; a line has %2 at most.</source>
            <translation>程序段有 %1 个字节；一行最多 %2 个。</translation>
        </message>
        <message>
            <source>The block is run.</source>
            <translation>程序段已运行。</translation>
        </message>
        <message>
            <source>The block runs.</source>
            <translation>程序段正在运行。</translation>
        </message>
        <message>
            <source>The built-in profile has no file: save it as one.</source>
            <translation>内置配置没有文件：请另存为文件。</translation>
        </message>
        <message>
            <source>The computer is too busy: give the core real-time rights, lengthen tick.period_us or raise tick.missed_alarm_per_s; then reset the alarm.</source>
            <translation>计算机太忙：请授予内核实时权限、加大 tick.period_us 或提高 tick.missed_alarm_per_s；然后复位报警。</translation>
        </message>
        <message>
            <source>The computer paused too long while an axis moved: give the core real-time rights or a quieter machine; reset the alarm, then home.</source>
            <translation>轴运动时计算机停顿过久：请授予内核实时权限或换更空闲的计算机；复位报警，然后回零。</translation>
        </message>
        <message>
            <source>The computer paused while axis %1 moved</source>
            <translation>轴 %1 运动时计算机停顿</translation>
        </message>
        <message>
            <source>The computer was too busy for the machine</source>
            <translation>计算机太忙，顾不上机床</translation>
        </message>
        <message>
            <source>The computer's memory says %1 layers, its disk %2: the lower number is taken.</source>
            <translation>计算机内存记录 %1 层，磁盘记录 %2 层：取较小者。</translation>
        </message>
        <message>
            <source>The connector's pins and their levels</source>
            <translation>接口引脚及其电平</translation>
        </message>
        <message>
            <source>The core ended in the middle of its work and its guard switched drives and spindle off: start the core again, home, and carve on from the layer it was in.</source>
            <translation>内核在工作中意外结束，守护进程已关闭驱动器和主轴：请重新启动内核，回零，然后从当时所在的层继续雕刻。</translation>
        </message>
        <message>
            <source>The core found: %1</source>
            <translation>内核发现：%1</translation>
        </message>
        <message>
            <source>The core has ended</source>
            <translation>内核已结束</translation>
        </message>
        <message>
            <source>The core has ended in layer %1</source>
            <translation>内核在第 %1 层结束</translation>
        </message>
        <message>
            <source>The core has ended in layer %1, point %2</source>
            <translation>内核在第 %1 层、第 %2 点结束</translation>
        </message>
        <message>
            <source>The core has ended in line %1 of its program</source>
            <translation>内核在其程序的第 %1 行结束</translation>
        </message>
        <message>
            <source>The core has ended in the middle of its work</source>
            <translation>内核在工作中途结束</translation>
        </message>
        <message>
            <source>The core has started: version %1, port %2, process %3</source>
            <translation>内核已启动：版本 %1，端口 %2，进程 %3</translation>
        </message>
        <message>
            <source>The core has this job.</source>
            <translation>内核已有此作业。</translation>
        </message>
        <message>
            <source>The core heard no command for a second, no stop either: free the computer of other work, look after its memory and disks; reset the alarm, then start again.</source>
            <translation>内核有一秒钟听不到任何命令，停止命令也听不到：请减轻计算机的其他负担，检查内存和磁盘；复位报警，然后重新启动。</translation>
        </message>
        <message>
            <source>The core is heard again</source>
            <translation>内核恢复响应</translation>
        </message>
        <message>
            <source>The core is silent</source>
            <translation>内核无响应</translation>
        </message>
        <message>
            <source>The core is silent in the middle of its work</source>
            <translation>内核在工作中途无响应</translation>
        </message>
        <message>
            <source>The core is silent, in layer %1, point %2</source>
            <translation>内核无响应，在第 %1 层、第 %2 点</translation>
        </message>
        <message>
            <source>The core is silent, in line %1 of its program</source>
            <translation>内核无响应，在其程序的第 %1 行</translation>
        </message>
        <message>
            <source>The core runs on a virtual clock: no tick is ever late</source>
            <translation>内核使用虚拟时钟：节拍从不迟滞</translation>
        </message>
        <message>
            <source>The core runs with another profile than %1; its file was not found.</source>
            <translation>内核使用的配置不是 %1，而是另一个；未找到其文件。</translation>
        </message>
        <message>
            <source>The core runs with profile %1, not with %2 of --profile</source>
            <translation>内核使用配置 %1，而非 --profile 的 %2</translation>
        </message>
        <message>
            <source>The core's profile is not known: give the window its file, with --profile</source>
            <translation>内核的配置未知：请用 --profile 指定其文件</translation>
        </message>
        <message>
            <source>The core's tick</source>
            <translation>内核节拍</translation>
        </message>
        <message>
            <source>The depth limit of %1 mm below the blank's surface keeps the heads out of %2 of the points, by up to %3 mm.</source>
            <translation>毛坯表面以下 %1 mm 的深度限制使刀头在 %2 的点上未切到位，最多差 %3 mm。</translation>
        </message>
        <message>
            <source>The desktop's bell, once at each new alarm; not for recordings, nor for what was there before the window</source>
            <translation>桌面提示音，每次新报警响一次；回放以及窗口打开之前的报警不响</translation>
        </message>
        <message>
            <source>The disk does not take how far the piece has come</source>
            <translation>磁盘无法记录工件的进度</translation>
        </message>
        <message>
            <source>The drawing does not say how large it is: its units are taken as 1/96 inch (0.26 mm).</source>
            <translation>图形未注明大小：其单位按 1/96 英寸（0.26 mm）计。</translation>
        </message>
        <message>
            <source>The drawing does not say its units: they are taken as millimetres.</source>
            <translation>图形未注明单位：按毫米计。</translation>
        </message>
        <message>
            <source>The emergency stop switch is still pressed</source>
            <translation>急停开关仍被按下</translation>
        </message>
        <message>
            <source>The file ends without endsolid.</source>
            <translation>文件结尾缺少 endsolid。</translation>
        </message>
        <message>
            <source>The file has been changed since it was read: decode it again.</source>
            <translation>文件在读取后已更改：请重新解析。</translation>
        </message>
        <message>
            <source>The file is not there any more</source>
            <translation>文件已不存在</translation>
        </message>
        <message>
            <source>The file was written since it was opened</source>
            <translation>文件在打开后被改写</translation>
        </message>
        <message>
            <source>The file was written since: it comes as it is now, and is not sliced.</source>
            <translation>该文件之后被改写：按现在的内容打开，不切片。</translation>
        </message>
        <message>
            <source>The finishing pass alone</source>
            <translation>只做精加工</translation>
        </message>
        <message>
            <source>The flight recorder does not reach back to that moment any more</source>
            <translation>飞行记录已不再包含那个时刻</translation>
        </message>
        <message>
            <source>The flight recorder is being saved</source>
            <translation>正在保存飞行记录</translation>
        </message>
        <message>
            <source>The gap between two step pulses lasts at least this long.</source>
            <translation>两个步进脉冲之间的间隔至少这么久。</translation>
        </message>
        <message>
            <source>The guard process ended: start the core again.</source>
            <translation>守护进程已结束：请重新启动内核。</translation>
        </message>
        <message>
            <source>The heads can go only %1 mm out of the blank before they begin, not the %2 mm of job.clearance_mm.</source>
            <translation>开始前刀头只能退到毛坯外 %1 mm，达不到 job.clearance_mm 的 %2 mm。</translation>
        </message>
        <message>
            <source>The heads come in: %1.</source>
            <translation>刀头进入：%1。</translation>
        </message>
        <message>
            <source>The heads may stand in the piece.</source>
            <translation>刀头可能停在工件中。</translation>
        </message>
        <message>
            <source>The heads stay out (dry run).</source>
            <translation>刀头留在外面（空运行）。</translation>
        </message>
        <message>
            <source>The heads wait at the first point; start or stop</source>
            <translation>刀头在第一点等待；请启动或停止</translation>
        </message>
        <message>
            <source>The job is ready to be published.</source>
            <translation>作业可以发布了。</translation>
        </message>
        <message>
            <source>The job or snapshot that this trace belongs to</source>
            <translation>此轨迹所属的作业或快照</translation>
        </message>
        <message>
            <source>The layer's begin, or the point at which the heads go in</source>
            <translation>该层起点，或刀头进给的那一点</translation>
        </message>
        <message>
            <source>The layers lie %1 mm apart, but the tool is only %2 mm wide: between them material stays, as high as the blank; more layers leave less.</source>
            <translation>各层相距 %1 mm，而刀具仅宽 %2 mm：层间会留下与毛坯等高的材料；层数越多，残留越少。</translation>
        </message>
        <message>
            <source>The least time that the motors' limits allow for the whole job</source>
            <translation>在电机限值内完成整个任务的最短时间</translation>
        </message>
        <message>
            <source>The live machine, not the recording</source>
            <translation>实际机床，不是记录</translation>
        </message>
        <message>
            <source>The log is not kept: %1</source>
            <translation>日志未保存：%1</translation>
        </message>
        <message>
            <source>The machine is at work no more: the window can be closed</source>
            <translation>机床已不在工作：可以关闭窗口</translation>
        </message>
        <message>
            <source>The machine is at work. It does not need this window: what is to become of it?</source>
            <translation>机床正在工作。它不需要此窗口：要如何处理？</translation>
        </message>
        <message>
            <source>The machine is under way; at rest, without a job that waits or is held</source>
            <translation>机床正在工作；须静止且没有等待或保持中的作业</translation>
        </message>
        <message>
            <source>The machine still has its job of before: Start carves %1.</source>
            <translation>机床仍是原来的作业：“启动”将雕刻 %1。</translation>
        </message>
        <message>
            <source>The machine's history is not shown in full</source>
            <translation>机床历史未能完整显示</translation>
        </message>
        <message>
            <source>The machine's profile is not known here: pins are those of the built-in profile.</source>
            <translation>此处不知道机床配置：引脚按内置配置显示。</translation>
        </message>
        <message>
            <source>The mesh has holes, which are carved down to what lies behind them, or to the core.</source>
            <translation>网格有孔洞：孔洞处会雕到其后的表面或芯部。</translation>
        </message>
        <message>
            <source>The mesh is inside out; carved as if it were not.</source>
            <translation>网格内外翻转；按未翻转雕刻。</translation>
        </message>
        <message>
            <source>The mesh is open at %1 of the samples; what is missing there is carved down to what lies behind it, or to the core.</source>
            <translation>网格在 %1 个采样处是开口的；缺失处将雕刻到其后的表面或芯部。</translation>
        </message>
        <message>
            <source>The model in space</source>
            <translation>空间中的模型</translation>
        </message>
        <message>
            <source>The model is only %1 mm high: are its units inches or metres? Height makes it larger.</source>
            <translation>模型只有 %1 mm 高：单位是英寸或米吗？用“高度”放大。</translation>
        </message>
        <message>
            <source>The model stands out of the blank, which is off the table's axis, by up to %1 mm in direction %2°.</source>
            <translation>毛坯偏离转台轴线，模型在 %2° 方向最多伸出毛坯 %1 mm。</translation>
        </message>
        <message>
            <source>The model stands so far from its file's origin that its coordinates are rounded to %1 mm, more than a pulse (%2 mm): move it to the origin before it is exported.</source>
            <translation>模型离文件原点太远，坐标被舍入到 %1 mm，超过一个脉冲（%2 mm）：导出前请移到原点。</translation>
        </message>
        <message>
            <source>The most between two of roughing's layers; 0: as the tool allows.</source>
            <translation>粗加工相邻两层的最大间距；0：按刀具允许。</translation>
        </message>
        <message>
            <source>The most between two of roughing's layers; auto: as the tool allows</source>
            <translation>粗加工相邻两层的最大间距；自动：按刀具允许</translation>
        </message>
        <message>
            <source>The old file is kept as a backup. A core takes a profile when it starts.</source>
            <translation>旧文件保留为备份。内核在启动时读取配置。</translation>
        </message>
        <message>
            <source>The old file is kept as a backup. Then start the core with the new one, and slice models anew: a job is made for one calibration.</source>
            <translation>旧文件保留为备份。之后用新文件启动内核，并重新切片：作业只对应一次校准。</translation>
        </message>
        <message>
            <source>The one before ended in order</source>
            <translation>上一个内核正常结束</translation>
        </message>
        <message>
            <source>The one before has no end, and the computer was started again since</source>
            <translation>上一个内核没有结束记录，此后计算机重新启动过</translation>
        </message>
        <message>
            <source>The one before has no end: killed, crashed, or the computer was switched off</source>
            <translation>上一个内核没有结束记录：被终止、崩溃或计算机断电</translation>
        </message>
        <message>
            <source>The one before was killed or crashed</source>
            <translation>上一个内核被终止或崩溃</translation>
        </message>
        <message>
            <source>The picture does not say what its fourth sample is: it is taken as transparency (alpha).</source>
            <translation>图片未说明第四通道是什么：按透明度（alpha）处理。</translation>
        </message>
        <message>
            <source>The picture ends before the full turn in steps to the white rest: of up to %1 mm at its left edge and %2 mm at its right one. White edges, or all round, leave none.</source>
            <translation>图片不足整周，边缘与其余的白色部分之间有台阶：左边缘最大 %1 mm，右边缘最大 %2 mm。边缘为白色或选择整周即可消除。</translation>
        </message>
        <message>
            <source>The picture is in colour; its brightness is taken.</source>
            <translation>图片是彩色的；取其亮度。</translation>
        </message>
        <message>
            <source>The picture's %1 x %2 pixels are averaged to %3 x %4.</source>
            <translation>图片的 %1 x %2 像素已平均为 %3 x %4。</translation>
        </message>
        <message>
            <source>The picture's left and right edges do not meet: a step of up to %1 mm at direction 0. Seam: blended makes it smooth.</source>
            <translation>图片左右边缘不相接：在方向 0 处有最大 %1 mm 的台阶。将“接缝”选为“平滑”可消除。</translation>
        </message>
        <message>
            <source>The port does not answer</source>
            <translation>端口没有应答</translation>
        </message>
        <message>
            <source>The profile is being opened</source>
            <translation>正在打开配置</translation>
        </message>
        <message>
            <source>The profile is being saved</source>
            <translation>正在保存配置</translation>
        </message>
        <message>
            <source>The profile is still being saved. Lose what is not saved yet?</source>
            <translation>配置仍在保存。要放弃尚未保存的内容吗？</translation>
        </message>
        <message>
            <source>The program is on its way to the machine.</source>
            <translation>程序正在送往机床。</translation>
        </message>
        <message>
            <source>The program runs. %1</source>
            <translation>程序正在运行。%1</translation>
        </message>
        <message>
            <source>The program's path; rapid moves are dashed</source>
            <translation>程序的路径；快速移动为虚线</translation>
        </message>
        <message>
            <source>The program's text</source>
            <translation>程序文本</translation>
        </message>
        <message>
            <source>The real machine at port %1</source>
            <translation>端口 %1 上的真实机床</translation>
        </message>
        <message>
            <source>The run before came to layer %1 of %2: if its piece is still mounted, From layer %3 goes on with it, and layer 1 carves it again.</source>
            <translation>上一次运行到第 %1 层（共 %2 层）：如果其工件仍装着，用“从层”%3 可继续；从第 1 层开始则会再次雕刻它。</translation>
        </message>
        <message>
            <source>The run before came to layer %1: if its piece is still mounted, From layer %2 goes on with it.</source>
            <translation>上一次运行到第 %1 层：如果其工件仍装着，用“从层”%2 可继续。</translation>
        </message>
        <message>
            <source>The shared memory was removed or damaged from outside: reset the alarm and publish the job again.</source>
            <translation>共享内存被外部删除或损坏：复位报警并重新发布作业。</translation>
        </message>
        <message>
            <source>The spindle goes on.</source>
            <translation>主轴打开。</translation>
        </message>
        <message>
            <source>The spindle is off. No axis moved, and drives without an enable line stay on.</source>
            <translation>主轴已关闭。没有轴移动，没有使能线的驱动保持通电。</translation>
        </message>
        <message>
            <source>The spindle is on and stays on.</source>
            <translation>主轴已打开并保持打开。</translation>
        </message>
        <message>
            <source>The spindle stays off until the program turns it on.</source>
            <translation>主轴保持关闭，直到程序打开它。</translation>
        </message>
        <message>
            <source>The table had lost steps there. Measure the piece, or go on from the first of these layers</source>
            <translation>转台在该处丢过步。请测量工件，或从其中第一层继续</translation>
        </message>
        <message>
            <source>The table has lost steps</source>
            <translation>转台丢步</translation>
        </message>
        <message>
            <source>The table is taken as it stands: R2's angle and height errors stay in it.</source>
            <translation>表格按原样采用：R2 的角度和高度误差仍在其中。</translation>
        </message>
        <message>
            <source>The table keeps turning, runs to and fro, or the heads rise as it turns, without links; a job carries its own.</source>
            <translation>转台持续转动、往复转动，或刀头随转动上升而无层间连接；作业自带此设置。</translation>
        </message>
        <message>
            <source>The text has more than one line; only one block is run.</source>
            <translation>文本多于一行；只运行一个程序段。</translation>
        </message>
        <message>
            <source>The tool alone: no blank is chosen</source>
            <translation>只有刀具：未选毛坯</translation>
        </message>
        <message>
            <source>The tool cuts %1 mm deep, but the job goes %2 mm into the blank.</source>
            <translation>刀具切深 %1 mm，而作业切入毛坯 %2 mm。</translation>
        </message>
        <message>
            <source>The tool has become this much shorter since the touch-off; added to the tip offset.</source>
            <translation>对刀之后刀具变短了这么多；加到刀尖偏移上。</translation>
        </message>
        <message>
            <source>The tool is a point, which leaves no width: grooves are as wide as the real tool cuts them.</source>
            <translation>刀具为点，没有宽度：刻槽与实际刀具切出的同宽。</translation>
        </message>
        <message>
            <source>The tool leaves</source>
            <translation>刀具留下</translation>
        </message>
        <message>
            <source>The tool leaves (draft)</source>
            <translation>刀具留下（草图）</translation>
        </message>
        <message>
            <source>The typed block runs. %1</source>
            <translation>输入的程序段正在运行。%1</translation>
        </message>
        <message>
            <source>The unfinished piece is forgotten.</source>
            <translation>未完成的工件已被忘记。</translation>
        </message>
        <message>
            <source>The window stays open: the core has not taken the hold</source>
            <translation>窗口保持打开：内核未接受暂停</translation>
        </message>
        <message>
            <source>The Ψ index did not come where it was expected.</source>
            <translation>Ψ 零位没有在预期处出现。</translation>
        </message>
        <message>
            <source>The Ψ index was expected at %1 pulses and came at %2. Likely the table was held or braked.</source>
            <translation>Ψ 零位预期在 %1 脉冲，实际在 %2。可能转台被卡住或制动。</translation>
        </message>
        <message>
            <source>The Ψ index was expected at %1 pulses and came at %2: the table stands %3 off. Likely it was held or braked.</source>
            <translation>Ψ 零位预期在 %1 脉冲，实际在 %2：转台偏差 %3。可能被卡住或制动。</translation>
        </message>
        <message>
            <source>The Ψ index was expected at %1 pulses and came at %2: the table stands %3 off. Likely it was held or braked. Layer %4 can be wrong.</source>
            <translation>Ψ 零位预期在 %1 脉冲，实际在 %2：转台偏差 %3。可能被卡住或制动。第 %4 层可能有误。</translation>
        </message>
        <message>
            <source>The Ψ index was expected at %1 pulses and came at %2: the table stands %3 off. Likely it was held or braked. Layers %4 to %5 can be wrong.</source>
            <translation>Ψ 零位预期在 %1 脉冲，实际在 %2：转台偏差 %3。可能被卡住或制动。第 %4 至 %5 层可能有误。</translation>
        </message>
        <message>
            <source>Theme</source>
            <translation>主题</translation>
        </message>
        <message>
            <source>Then keys move the machine (F9)</source>
            <translation>之后可用键盘移动机床 (F9)</translation>
        </message>
        <message>
            <source>Then outputs can be switched one by one</source>
            <translation>之后可逐个切换输出</translation>
        </message>
        <message>
            <source>Then: heads out, Ψ to %1°, Y to %2 mm, spindle on, heads in to R1 %3, R2 %4 mm.</source>
            <translation>然后：刀头退出，Ψ 到 %1°，Y 到 %2 mm，主轴开，刀头进到 R1 %3、R2 %4 mm。</translation>
        </message>
        <message>
            <source>These outputs go on: %1.</source>
            <translation>这些输出接通：%1。</translation>
        </message>
        <message>
            <source>This computer</source>
            <translation>本机</translation>
        </message>
        <message>
            <source>This core keeps pieces elsewhere, or nowhere: it is another core's.</source>
            <translation>此内核把工件记录在别处或不记录：这是另一个内核的。</translation>
        </message>
        <message>
            <source>This is known from the disk alone. Go on only if this very piece is still mounted, as it was, with this tool.</source>
            <translation>这些仅从磁盘得知。只有当这件工件仍按原样装夹、刀具也相同时才继续。</translation>
        </message>
        <message>
            <source>This user has no folder to keep it in</source>
            <translation>该用户没有可存放它的文件夹</translation>
        </message>
        <message>
            <source>This window goes by it from now on, also without a core; no file is changed</source>
            <translation>此后本窗口以它为准，无内核时亦然；不修改任何文件</translation>
        </message>
        <message>
            <source>Thread</source>
            <translation>线程</translation>
        </message>
        <message>
            <source>Tick</source>
            <translation>节拍</translation>
        </message>
        <message>
            <source>Tick to measure with</source>
            <translation>测量所用节拍</translation>
        </message>
        <message>
            <source>Ticks by how late they were (logarithmic)</source>
            <translation>按迟滞量统计的节拍（对数）</translation>
        </message>
        <message>
            <source>Ticks in time</source>
            <translation>节拍准时</translation>
        </message>
        <message>
            <source>Ticks in which a step waited for its pin</source>
            <translation>步进等待引脚的节拍</translation>
        </message>
        <message>
            <source>Ticks measured, missed</source>
            <translation>测量的节拍，错过的</translation>
        </message>
        <message>
            <source>Ticks per second</source>
            <translation>每秒节拍</translation>
        </message>
        <message>
            <source>Ticks since the core started</source>
            <translation>内核启动以来的节拍</translation>
        </message>
        <message>
            <source>Ticks were missed (%1 since the core started); motors may have lost steps.</source>
            <translation>有节拍丢失（内核启动以来 %1 个）；电机可能已丢步。</translation>
        </message>
        <message>
            <source>Ticks were missed; motors may have lost steps.</source>
            <translation>有节拍丢失；电机可能已丢步。</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>时间</translation>
        </message>
        <message>
            <source>Timeline of the recording</source>
            <translation>记录时间轴</translation>
        </message>
        <message>
            <source>To a position: one axis or several, straight or on an arc</source>
            <translation>移动到某位置：一个或多个轴，直线或圆弧</translation>
        </message>
        <message>
            <source>To be looked at before Start: %1</source>
            <translation>启动前请留意：%1</translation>
        </message>
        <message>
            <source>To go: %1</source>
            <translation>剩余：%1</translation>
        </message>
        <message>
            <source>To run it again</source>
            <translation>重新运行</translation>
        </message>
        <message>
            <source>To the begin</source>
            <translation>到开头</translation>
        </message>
        <message>
            <source>To the end</source>
            <translation>到结尾</translation>
        </message>
        <message>
            <source>To the entry before (Shift+N)</source>
            <translation>到上一条 (Shift+N)</translation>
        </message>
        <message>
            <source>To the first point</source>
            <translation>移到第一点</translation>
        </message>
        <message>
            <source>To the next entry (N)</source>
            <translation>到下一条 (N)</translation>
        </message>
        <message>
            <source>Too deep by %1 mm at most, at %2°, %3 mm high</source>
            <translation>最多过深 %1 mm，在 %2°、高 %3 mm 处</translation>
        </message>
        <message>
            <source>Tool</source>
            <translation>刀具</translation>
        </message>
        <message>
            <source>Tool over surface; a job carries its own.</source>
            <translation>刀具相对表面的速度；作业自带此设置。</translation>
        </message>
        <message>
            <source>Tools</source>
            <translation>工具</translation>
        </message>
        <message>
            <source>Top</source>
            <translation>上</translation>
        </message>
        <message>
            <source>Top of the cylinder above the table; 0: not known.</source>
            <translation>圆柱顶面距工作台的高度；0：未知。</translation>
        </message>
        <message>
            <source>Top speed that the motor follows (v_k).</source>
            <translation>电机能跟上的最高速度（v_k）。</translation>
        </message>
        <message>
            <source>Total time</source>
            <translation>总时间</translation>
        </message>
        <message>
            <source>Touch-off of %1</source>
            <translation>%1 对刀</translation>
        </message>
        <message>
            <source>Touch-off, two marks and tool wear become values of the profile, step by step</source>
            <translation>对刀、两个标记和刀具磨损逐步成为配置中的值</translation>
        </message>
        <message>
            <source>Touch-off: the real tip stands this much further out than counted.</source>
            <translation>对刀：实际刀尖比计数位置更靠外的量。</translation>
        </message>
        <message>
            <source>Touches no machine. Measure does so at length.</source>
            <translation>不接触机床。“测量”可长时间检查。</translation>
        </message>
        <message>
            <source>Trace to verify</source>
            <translation>要校验的轨迹</translation>
        </message>
        <message>
            <source>Traces (*.trace *.vcd);;All files (*)</source>
            <translation>轨迹 (*.trace *.vcd);;所有文件 (*)</translation>
        </message>
        <message>
            <source>Turn about X</source>
            <translation>绕 X 旋转</translation>
        </message>
        <message>
            <source>Turn, mirror</source>
            <translation>旋转、镜像</translation>
        </message>
        <message>
            <source>Turns or mirrors the model before it is placed</source>
            <translation>在放置模型之前旋转或镜像</translation>
        </message>
        <message>
            <source>Two marks</source>
            <translation>两个标记</translation>
        </message>
        <message>
            <source>Undercut</source>
            <translation>倒扣</translation>
        </message>
        <message>
            <source>Undercut: choose Model first</source>
            <translation>倒扣：请先选择“模型”</translation>
        </message>
        <message>
            <source>Undercut: it is being looked for</source>
            <translation>倒扣：正在查找</translation>
        </message>
        <message>
            <source>Undercut: open a model first</source>
            <translation>倒扣：请先打开模型</translation>
        </message>
        <message>
            <source>Undercut: there is none</source>
            <translation>倒扣：没有</translation>
        </message>
        <message>
            <source>Undo all</source>
            <translation>全部撤销</translation>
        </message>
        <message>
            <source>Undo all: nothing was changed</source>
            <translation>全部撤销：没有任何更改</translation>
        </message>
        <message>
            <source>Unfinished: %1 of %2 layers are carved</source>
            <translation>未完成：已雕刻 %1 层，共 %2 层</translation>
        </message>
        <message>
            <source>Unfinished: %1 of %2 layers of %3 are carved</source>
            <translation>未完成：“%3”已雕刻 %1 层，共 %2 层</translation>
        </message>
        <message>
            <source>Unfinished: a part of the first of %1 layers is carved</source>
            <translation>未完成：%1 层中的第一层已雕刻一部分</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>单位</translation>
        </message>
        <message>
            <source>Unrolled</source>
            <translation>展开</translation>
        </message>
        <message>
            <source>Unrolled Ψ–Y map:</source>
            <translation>Ψ–Y 展开图：</translation>
        </message>
        <message>
            <source>Up axis</source>
            <translation>向上的轴</translation>
        </message>
        <message>
            <source>Up to %1 roughing passes of all layers</source>
            <translation>最多 %1 道粗加工，走全部层</translation>
        </message>
        <message>
            <source>Up to %1 roughing passes, layers %2 mm apart</source>
            <translation>最多 %1 道粗加工，层距 %2 mm</translation>
        </message>
        <message>
            <source>Use the core's profile</source>
            <translation>采用内核的配置</translation>
        </message>
        <message>
            <source>Use the switch on the machine to stop it</source>
            <translation>请用机床上的开关停机</translation>
        </message>
        <message>
            <source>Use the wired emergency stop, or the machine's own switch</source>
            <translation>请按硬接线急停或机床自身的开关</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>数值</translation>
        </message>
        <message>
            <source>Values that need a restart (↻): %1.</source>
            <translation>需要重启的值（↻）：%1。</translation>
        </message>
        <message>
            <source>Verification</source>
            <translation>校验</translation>
        </message>
        <message>
            <source>Verification found a difference</source>
            <translation>校验发现差异</translation>
        </message>
        <message>
            <source>Verification found a difference: %1</source>
            <translation>校验发现差异：%1</translation>
        </message>
        <message>
            <source>Verified</source>
            <translation>已校验</translation>
        </message>
        <message>
            <source>Verified as far as it was recorded, largest deviation %1 pulses</source>
            <translation>已校验到记录末尾，最大偏差 %1 个脉冲</translation>
        </message>
        <message>
            <source>Verified: the pins carve the job, largest deviation %1 pulses</source>
            <translation>已校验：引脚雕出该任务，最大偏差 %1 个脉冲</translation>
        </message>
        <message>
            <source>Verified: the pulses of a dry run, which carves nothing</source>
            <translation>已校验：空运行的脉冲，空运行不雕刻</translation>
        </message>
        <message>
            <source>Verify</source>
            <translation>校验</translation>
        </message>
        <message>
            <source>Verify a trace…</source>
            <translation>校验轨迹…</translation>
        </message>
        <message>
            <source>Verify: add its job first</source>
            <translation>校验：请先添加其任务</translation>
        </message>
        <message>
            <source>Verifying %1</source>
            <translation>正在校验 %1</translation>
        </message>
        <message>
            <source>View</source>
            <translation>视图</translation>
        </message>
        <message>
            <source>Volume</source>
            <translation>体积</translation>
        </message>
        <message>
            <source>WAITING</source>
            <translation>等待</translation>
        </message>
        <message>
            <source>Wait from spindle on to the first move inwards.</source>
            <translation>主轴启动到首次进刀之间的等待。</translation>
        </message>
        <message>
            <source>Warning</source>
            <translation>警告</translation>
        </message>
        <message>
            <source>Warnings</source>
            <translation>警告</translation>
        </message>
        <message>
            <source>Wear of the tool of %1</source>
            <translation>%1 的刀具磨损</translation>
        </message>
        <message>
            <source>What</source>
            <translation>内容</translation>
        </message>
        <message>
            <source>What becomes of it</source>
            <translation>结果</translation>
        </message>
        <message>
            <source>What happened</source>
            <translation>发生了什么</translation>
        </message>
        <message>
            <source>What is wrong with the program; a click goes to the line</source>
            <translation>程序的问题；点击转到该行</translation>
        </message>
        <message>
            <source>What keeps ticks in time</source>
            <translation>节拍准时的条件</translation>
        </message>
        <message>
            <source>What roughing leaves for the finishing pass</source>
            <translation>粗加工留给精加工的量</translation>
        </message>
        <message>
            <source>What roughing leaves for the finishing pass, along the radius.</source>
            <translation>粗加工沿半径留给精加工的量。</translation>
        </message>
        <message>
            <source>What the job and its tool will leave, and how far it is from the model</source>
            <translation>作业及其刀具会留下什么，与模型相差多少</translation>
        </message>
        <message>
            <source>What the map shows</source>
            <translation>展开图显示的内容</translation>
        </message>
        <message>
            <source>What the mesh is made of, what is wrong with it and what no tool reaches</source>
            <translation>网格由什么组成、有什么问题、哪些地方刀具够不到</translation>
        </message>
        <message>
            <source>What to do</source>
            <translation>如何处理</translation>
        </message>
        <message>
            <source>What was measured so far is the result</source>
            <translation>以目前测得的为结果</translation>
        </message>
        <message>
            <source>Where %1 is shown to stand</source>
            <translation>显示的 %1 位置</translation>
        </message>
        <message>
            <source>Where the blank's axis stands off the table's, towards direction 0°</source>
            <translation>毛坯轴线相对转台轴线的偏移，朝 0° 方向</translation>
        </message>
        <message>
            <source>Where the blank's axis stands off the table's, towards direction 90°</source>
            <translation>毛坯轴线相对转台轴线的偏移，朝 90° 方向</translation>
        </message>
        <message>
            <source>Where the cylinder's axis stands off the table's, towards direction 0.</source>
            <translation>圆柱轴线相对转台轴线的偏移，朝 0° 方向。</translation>
        </message>
        <message>
            <source>Where the cylinder's axis stands off the table's, towards direction 90.</source>
            <translation>圆柱轴线相对转台轴线的偏移，朝 90° 方向。</translation>
        </message>
        <message>
            <source>Where the leftmost of the drawing's lines stands</source>
            <translation>图形中最左边的线所在的方向</translation>
        </message>
        <message>
            <source>Where the picture's left and right edges meet</source>
            <translation>图片左右边缘相接处</translation>
        </message>
        <message>
            <source>Whether the table has an index sensor.</source>
            <translation>转台是否有零位传感器。</translation>
        </message>
        <message>
            <source>Which messages are shown</source>
            <translation>显示哪些消息</translation>
        </message>
        <message>
            <source>While a recording is shown</source>
            <translation>显示记录时</translation>
        </message>
        <message>
            <source>While keys are armed (F9)</source>
            <translation>键盘点动启用时（F9）</translation>
        </message>
        <message>
            <source>Wiring test</source>
            <translation>接线测试</translation>
        </message>
        <message>
            <source>Wiring test, recording pins…</source>
            <translation>接线测试、记录引脚…</translation>
        </message>
        <message>
            <source>Wiring test: arm it first</source>
            <translation>接线测试：请先启用</translation>
        </message>
        <message>
            <source>Wiring test: switch the drives off first</source>
            <translation>接线测试：请先关闭驱动</translation>
        </message>
        <message>
            <source>With those before</source>
            <translation>含前面各层</translation>
        </message>
        <message>
            <source>Within a pulse %1 % of the surface, removed %2 cm³</source>
            <translation>一个脉冲以内占表面 %1 %，去除 %2 cm³</translation>
        </message>
        <message>
            <source>Working the expected piece out</source>
            <translation>正在计算预期工件</translation>
        </message>
        <message>
            <source>Working the piece out was cancelled</source>
            <translation>工件计算已取消</translation>
        </message>
        <message>
            <source>Working the piece out: %1 %</source>
            <translation>正在计算工件：%1 %</translation>
        </message>
        <message>
            <source>Write</source>
            <translation>写入</translation>
        </message>
        <message>
            <source>Write: nothing was measured</source>
            <translation>写入：没有测量值</translation>
        </message>
        <message>
            <source>Write: step %1 cannot be</source>
            <translation>写入：第 %1 步的值不可能</translation>
        </message>
        <message>
            <source>Write: the machine moves</source>
            <translation>写入：机床在运动</translation>
        </message>
        <message>
            <source>Y direction</source>
            <translation>Y 方向</translation>
        </message>
        <message>
            <source>Y down</source>
            <translation>Y 下</translation>
        </message>
        <message>
            <source>Y enable</source>
            <translation>Y 使能</translation>
        </message>
        <message>
            <source>Y goes to %1 mm.</source>
            <translation>Y 移到 %1 mm。</translation>
        </message>
        <message>
            <source>Y limit</source>
            <translation>Y 限位</translation>
        </message>
        <message>
            <source>Y step</source>
            <translation>Y 步进</translation>
        </message>
        <message>
            <source>Y up</source>
            <translation>Y 上</translation>
        </message>
        <message>
            <source>Zero %1</source>
            <translation>%1 设零</translation>
        </message>
        <message>
            <source>Zero of %1: %2</source>
            <translation>%1 零点：%2</translation>
        </message>
        <message>
            <source>Zero: axis %1 is not homed</source>
            <translation>设零：轴 %1 未回零</translation>
        </message>
        <message>
            <source>Zero: the machine's profile is not known here</source>
            <translation>设零：此处不知道机床配置</translation>
        </message>
        <message>
            <source>[ has no ]</source>
            <translation>[ 没有对应的 ]</translation>
        </message>
        <message>
            <source>[ is missing</source>
            <translation>缺少 [</translation>
        </message>
        <message>
            <source>a %1 drawing, which is not read; save it as %2</source>
            <translation>%1 图纸，无法读取；请另存为 %2</translation>
        </message>
        <message>
            <source>a %1 model, which is not read; save it as STL or 3MF</source>
            <translation>%1 模型，无法读取；请另存为 STL 或 3MF</translation>
        </message>
        <message>
            <source>a %1 picture, which is not read; save it as PNG</source>
            <translation>%1 图片，无法读取；请另存为 PNG</translation>
        </message>
        <message>
            <source>a BMP picture of OS/2's kind, which is not read</source>
            <translation>OS/2 类型的 BMP 图片，无法读取</translation>
        </message>
        <message>
            <source>a BMP picture of a kind that is not read (%1 bits, compression %2); save it as PNG</source>
            <translation>无法读取此类 BMP 图片（%1 位，压缩 %2）；请存为 PNG</translation>
        </message>
        <message>
            <source>a SPLINE whose knots and points do not belong together is left out.</source>
            <translation>SPLINE 的节点与控制点不匹配，已略去。</translation>
        </message>
        <message>
            <source>a TIFF picture of %1 bits a sample: 8 or 16 are read</source>
            <translation>TIFF 图片每通道 %1 位：只读取 8 或 16 位</translation>
        </message>
        <message>
            <source>a TIFF picture of a kind that is not read (%1 samples of %2 bits, photometric %3); save it as PNG</source>
            <translation>无法读取此类 TIFF 图片（%1 个通道，每个 %2 位，photometric %3）；请存为 PNG</translation>
        </message>
        <message>
            <source>a TIFF picture of signed or floating numbers; save it with 8 or 16 bits</source>
            <translation>TIFF 图片为有符号数或浮点数；请以 8 或 16 位保存</translation>
        </message>
        <message>
            <source>a TIFF picture that is packed in a way that is not read (compression %1); save it as PNG</source>
            <translation>TIFF 图片的压缩方式无法读取（压缩 %1）；请存为 PNG</translation>
        </message>
        <message>
            <source>a TIFF picture whose samples are of different sizes; save it as PNG</source>
            <translation>TIFF 图片各通道位数不同；请存为 PNG</translation>
        </message>
        <message>
            <source>a binary DXF drawing; save it as text (ASCII DXF)</source>
            <translation>二进制 DXF 图形；请存为文本（ASCII DXF）</translation>
        </message>
        <message>
            <source>a block holds words, comments, / and %</source>
            <translation>程序段只包含字、注释、/ 和 %</translation>
        </message>
        <message>
            <source>a block of more than 100000 holes and pecks</source>
            <translation>一个程序段中的孔和啄钻超过 100000 次</translation>
        </message>
        <message>
            <source>a comment begins within a comment</source>
            <translation>注释中又开始注释</translation>
        </message>
        <message>
            <source>a control character in the text; remove it</source>
            <translation>文字中有控制字符；请删除</translation>
        </message>
        <message>
            <source>a coordinate is not a finite number</source>
            <translation>某坐标不是有限数</translation>
        </message>
        <message>
            <source>a cycle is done 1 to 100000 times</source>
            <translation>固定循环的次数为 1 至 100000</translation>
        </message>
        <message>
            <source>a cycle moves X, Y and Z alone</source>
            <translation>固定循环只移动 X、Y 和 Z</translation>
        </message>
        <message>
            <source>a cycle while %1 holds</source>
            <translation>%1 有效时使用固定循环</translation>
        </message>
        <message>
            <source>a cycle while G93 holds</source>
            <translation>G93 有效时使用固定循环</translation>
        </message>
        <message>
            <source>a cylinder's radius of less than 0</source>
            <translation>圆柱半径小于 0</translation>
        </message>
        <message>
            <source>a damaged %1 picture</source>
            <translation>%1 图片已损坏</translation>
        </message>
        <message>
            <source>a damaged %1 picture: %2</source>
            <translation>%1 图片已损坏：%2</translation>
        </message>
        <message>
            <source>a damaged %1 picture: the file ends too early</source>
            <translation>%1 图片已损坏：文件过早结束</translation>
        </message>
        <message>
            <source>a damaged BMP picture: its pixels are said to begin at byte %1, inside its head of %2</source>
            <translation>BMP 图片已损坏：其像素据称从第 %1 字节开始，位于 %2 字节的文件头之内</translation>
        </message>
        <message>
            <source>a damaged TIFF picture: its directory cannot be read</source>
            <translation>TIFF 图片已损坏：其目录无法读取</translation>
        </message>
        <message>
            <source>a damaged TIFF picture: its pixels cannot be unpacked</source>
            <translation>TIFF 图片已损坏：其像素无法解包</translation>
        </message>
        <message>
            <source>a date or time</source>
            <translation>日期或时间</translation>
        </message>
        <message>
            <source>a division by 0</source>
            <translation>除数为 0</translation>
        </message>
        <message>
            <source>a drawing without a width goes not all round</source>
            <translation>没有宽度的图形无法绕满一周</translation>
        </message>
        <message>
            <source>a drawn way is carved as with "path"</source>
            <translation>绘制的路径按 "path" 方式加工</translation>
        </message>
        <message>
            <source>a dwell of %1 s; the machine takes %2 s, a day, at most</source>
            <translation>停留 %1 s；机床最多 %2 s（一天）</translation>
        </message>
        <message>
            <source>a dwell of less than 0 s</source>
            <translation>停留时间小于 0 s</translation>
        </message>
        <message>
            <source>a face needs at least three vertices</source>
            <translation>一个面至少需要三个顶点</translation>
        </message>
        <message>
            <source>a facet needs three vertices</source>
            <translation>一个三角面需要三个顶点</translation>
        </message>
        <message>
            <source>a facet without endfacet</source>
            <translation>有 facet 缺少 endfacet</translation>
        </message>
        <message>
            <source>a job runs (%1); stop it or wait for its end</source>
            <translation>作业正在运行（%1）；请停止或等待其结束</translation>
        </message>
        <message>
            <source>a layer has %1 points: no carving begins beyond them, nor with its last</source>
            <translation>每层有 %1 个点：不能从其后或从最后一点开始</translation>
        </message>
        <message>
            <source>a layer is a whole number</source>
            <translation>层号须为整数</translation>
        </message>
        <message>
            <source>a layer needs its height and at least two radii</source>
            <translation>每层需要高度和至少两个半径</translation>
        </message>
        <message>
            <source>a layer of one point goes nowhere; it needs two</source>
            <translation>只有一个点的层没有走向；至少需要两个点</translation>
        </message>
        <message>
            <source>a layer sweeps %1 pulses of Ψ, half a revolution of this machine is %2; slice the model for this machine's profile</source>
            <translation>一层扫过 Ψ 的 %1 个脉冲，本机床半圈为 %2 个；请按本机床的配置切片</translation>
        </message>
        <message>
            <source>a line is carved as with "path": both heads move</source>
            <translation>直线按 "path" 方式加工：两个刀头都移动</translation>
        </message>
        <message>
            <source>a line is carved as with "path": psi turns</source>
            <translation>直线按 "path" 方式加工：psi 转动</translation>
        </message>
        <message>
            <source>a move that cuts, and the feed is 0</source>
            <translation>切削运动，而进给为 0</translation>
        </message>
        <message>
            <source>a move under G93 without F</source>
            <translation>G93 下的运动没有 F</translation>
        </message>
        <message>
            <source>a move under G95, and no spindle speed</source>
            <translation>G95 下的运动没有主轴转速</translation>
        </message>
        <message>
            <source>a name without letters</source>
            <translation>名称中没有字母</translation>
        </message>
        <message>
            <source>a negative number to a power that is not whole</source>
            <translation>负数的非整数次幂</translation>
        </message>
        <message>
            <source>a number</source>
            <translation>数字</translation>
        </message>
        <message>
            <source>a number alone begins a subroutine for M98, within another block</source>
            <translation>单独的编号是 M98 子程序的开头，却位于另一程序块内</translation>
        </message>
        <message>
            <source>a number of more than 1000000000</source>
            <translation>数字大于 1000000000</translation>
        </message>
        <message>
            <source>a number that no machine has</source>
            <translation>超出任何机床范围的数</translation>
        </message>
        <message>
            <source>a number with a fraction</source>
            <translation>带小数的数</translation>
        </message>
        <message>
            <source>a packed file (gzip), as SVGZ is; unpack it first</source>
            <translation>压缩文件（gzip），例如 SVGZ；请先解压</translation>
        </message>
        <message>
            <source>a page that was taken away stops the tick until it is back; a real machine is refused</source>
            <translation>被换出的内存页会使节拍停住直到取回；拒绝驱动真实机床</translation>
        </message>
        <message>
            <source>a parameter stands here, and sets nothing</source>
            <translation>此处的参数没有赋值</translation>
        </message>
        <message>
            <source>a peck is more than 0 deep</source>
            <translation>啄钻深度必须大于 0</translation>
        </message>
        <message>
            <source>a picture %1 mm high would be %2 mm wide, and once round are only %3 mm: choose at most %4 mm of height, a larger diameter, or all round, which changes its shape</source>
            <translation>图片高 %1 mm 时宽 %2 mm，而一周只有 %3 mm：高度最多选 %4 mm，或加大直径，或选整周（会改变形状）</translation>
        </message>
        <message>
            <source>a picture of %1 x %2 pixels; at most 100 million can be read, and 65535 a side</source>
            <translation>图片为 %1 x %2 像素；最多可读 1 亿像素，每边 65535</translation>
        </message>
        <message>
            <source>a picture without pixels</source>
            <translation>没有像素的图片</translation>
        </message>
        <message>
            <source>a place</source>
            <translation>指定位置</translation>
        </message>
        <message>
            <source>a place beyond 1 000 000 000 mm</source>
            <translation>位置超出 1 000 000 000 mm</translation>
        </message>
        <message>
            <source>a point</source>
            <translation>尖点</translation>
        </message>
        <message>
            <source>a point carves every layer, whatever the stepover; choose a tool</source>
            <translation>尖点总是走每一层，与层距无关；请选择刀具</translation>
        </message>
        <message>
            <source>a point leaves nothing, so there is no draft; slice first</source>
            <translation>尖点不留余料，没有草图；请先切片</translation>
        </message>
        <message>
            <source>a processor that first speeds up makes ticks late</source>
            <translation>需要先升频的处理器会使节拍迟到</translation>
        </message>
        <message>
            <source>a published job is being looked at; start once it is accepted</source>
            <translation>已发布的作业正在检查；接受之后再启动</translation>
        </message>
        <message>
            <source>a pulse, its gap and the writes take %1 us, more than a tick of %2 us; lengthen tick.period_us, shorten port.step_high_ns or port.step_low_ns, or set port.pulses = "over-ticks"</source>
            <translation>一个脉冲、其间隔和写端口共需 %1 us，超过一个 %2 us 的节拍；请加长 tick.period_us，缩短 port.step_high_ns 或 port.step_low_ns，或设 port.pulses = "over-ticks"</translation>
        </message>
        <message>
            <source>a radius of %1 mm does not reach the end, which is %2 mm away</source>
            <translation>半径 %1 mm 够不到 %2 mm 外的终点</translation>
        </message>
        <message>
            <source>a record was refused</source>
            <translation>有记录被拒绝</translation>
        </message>
        <message>
            <source>a recorded run is being replayed</source>
            <translation>正在重放已记录的运行</translation>
        </message>
        <message>
            <source>a recording is shown; leave replay first</source>
            <translation>正在显示记录；请先退出回放</translation>
        </message>
        <message>
            <source>a stepdown of %1 makes more than %2 passes</source>
            <translation>下切步距 %1 会超过 %2 道</translation>
        </message>
        <message>
            <source>a stepover of %1 is more than the tool is wide, %2</source>
            <translation>层距 %1 大于刀具宽度 %2</translation>
        </message>
        <message>
            <source>a stop came after it; ask again</source>
            <translation>此命令之后收到了停止命令；请重新发出</translation>
        </message>
        <message>
            <source>a stop of the program (M0); Resume goes on</source>
            <translation>程序停止（M0）；按“继续”接着运行</translation>
        </message>
        <message>
            <source>a string</source>
            <translation>字符串</translation>
        </message>
        <message>
            <source>a subroutine within another block</source>
            <translation>子程序位于另一程序块内</translation>
        </message>
        <message>
            <source>a switch was tripped until just now; try again</source>
            <translation>开关刚才仍处于触发状态；请再试一次</translation>
        </message>
        <message>
            <source>a table</source>
            <translation>表</translation>
        </message>
        <message>
            <source>a table of layers is no spiral: choose Joining continuous or zigzag</source>
            <translation>分层表格不是螺旋：请将层间连接选为连续或往复</translation>
        </message>
        <message>
            <source>a text of %1 bytes; give %2 to %3 bytes</source>
            <translation>文字长 %1 字节；请输入 %2 到 %3 字节</translation>
        </message>
        <message>
            <source>a tolerance of less than 0</source>
            <translation>公差小于 0</translation>
        </message>
        <message>
            <source>a tool change (M6); Resume goes on</source>
            <translation>换刀（M6）；按“继续”接着运行</translation>
        </message>
        <message>
            <source>a tool does not become %1 mm shorter; 0 to %2 mm, else touch the head off anew</source>
            <translation>刀具不会短 %1 mm；可为 0 至 %2 mm，否则请重新对刀</translation>
        </message>
        <message>
            <source>a transform that cannot be read; the element is left out.</source>
            <translation>变换无法读取；该元素已略去。</translation>
        </message>
        <message>
            <source>a value is missing</source>
            <translation>缺少值</translation>
        </message>
        <message>
            <source>a virtual machine</source>
            <translation>虚拟机</translation>
        </message>
        <message>
            <source>a wait of less than 0 s</source>
            <translation>等待时间小于 0 s</translation>
        </message>
        <message>
            <source>a way of %1 s; the machine takes %2 s, a day, at most</source>
            <translation>行程耗时 %1 s；机床最多 %2 s（一天）</translation>
        </message>
        <message>
            <source>a way of more than 100000 chords</source>
            <translation>一条路径超过 100000 段弦</translation>
        </message>
        <message>
            <source>a whole number</source>
            <translation>整数</translation>
        </message>
        <message>
            <source>about %1</source>
            <translation>约 %1</translation>
        </message>
        <message>
            <source>about %1 % of the surface</source>
            <translation>约占表面的 %1 %</translation>
        </message>
        <message>
            <source>about %1 left</source>
            <translation>剩余约 %1</translation>
        </message>
        <message>
            <source>add the word</source>
            <translation>请补上该字</translation>
        </message>
        <message>
            <source>alarm</source>
            <translation>报警</translation>
        </message>
        <message>
            <source>alarm: %1</source>
            <translation>报警：%1</translation>
        </message>
        <message>
            <source>alarm: %1, axis %2</source>
            <translation>报警：%1，%2 轴</translation>
        </message>
        <message>
            <source>all radii are the core radius of %1 mm: nothing but a plain rod would be carved; larger radii, or a smaller core_radius_mm, carve more</source>
            <translation>所有半径都等于芯半径 %1 mm：只会雕出一根光杆；请用更大的半径，或减小 core_radius_mm</translation>
        </message>
        <message>
            <source>allow it: a line "@GROUP - rtprio 90" in /etc/security/limits.d and a new login, or the capability CAP_SYS_NICE; in a container, real-time time for its control group</source>
            <translation>请允许：在 /etc/security/limits.d 中加入一行 "@GROUP - rtprio 90" 并重新登录，或授予 CAP_SYS_NICE 能力；在容器中，为其控制组分配实时时间</translation>
        </message>
        <message>
            <source>allow writing to /dev/cpu_dma_latency: a udev rule KERNEL=="cpu_dma_latency", GROUP="GROUP", MODE="0660", and be in that group</source>
            <translation>允许写 /dev/cpu_dma_latency：udev 规则 KERNEL=="cpu_dma_latency", GROUP="GROUP", MODE="0660"，并加入该组</translation>
        </message>
        <message>
            <source>allowed by CAP_IPC_LOCK</source>
            <translation>由 CAP_IPC_LOCK 允许</translation>
        </message>
        <message>
            <source>allowed by CAP_SYS_NICE</source>
            <translation>由 CAP_SYS_NICE 允许</translation>
        </message>
        <message>
            <source>allowed by CAP_SYS_RAWIO</source>
            <translation>由 CAP_SYS_RAWIO 允许</translation>
        </message>
        <message>
            <source>an O word stands behind other words</source>
            <translation>O 字位于其他字之后</translation>
        </message>
        <message>
            <source>an arc has 1 to 1000000 turns</source>
            <translation>圆弧的圈数为 1 至 1000000</translation>
        </message>
        <message>
            <source>an arc in %1 does not move Y and one head</source>
            <translation>%1 平面的圆弧不是由 Y 和一个刀头完成</translation>
        </message>
        <message>
            <source>an arc in %1 of a system that is rotated</source>
            <translation>旋转的坐标系中 %1 平面的圆弧</translation>
        </message>
        <message>
            <source>an arc of more than 100000 chords</source>
            <translation>一段圆弧超过 100000 段弦</translation>
        </message>
        <message>
            <source>an arc stays chords: another axis moves with it</source>
            <translation>圆弧仍按弦加工：另有轴随之移动</translation>
        </message>
        <message>
            <source>an arc stays chords: both heads draw it</source>
            <translation>圆弧仍按弦加工：由两个刀头完成</translation>
        </message>
        <message>
            <source>an arc stays chords: it comes within two pulses of the end of a travel or of the core</source>
            <translation>圆弧仍按弦加工：它距行程端或芯部不足两个脉冲</translation>
        </message>
        <message>
            <source>an arc stays chords: its ends are not, to a pulse, as far from the centre as each other</source>
            <translation>圆弧仍按弦加工：两端到圆心的距离相差超过一个脉冲</translation>
        </message>
        <message>
            <source>an arc stays chords: its ends differ and are within 16 pulses of each other</source>
            <translation>圆弧仍按弦加工：两端不同，但相距不足 16 个脉冲</translation>
        </message>
        <message>
            <source>an arc stays chords: its head and y differ in pulses per mm</source>
            <translation>圆弧仍按弦加工：刀头与 y 的每 mm 脉冲数不同</translation>
        </message>
        <message>
            <source>an arc stays chords: its radius is below 16 pulses</source>
            <translation>圆弧仍按弦加工：半径小于 16 个脉冲</translation>
        </message>
        <message>
            <source>an arc stays chords: its radius is too large</source>
            <translation>圆弧仍按弦加工：半径太大</translation>
        </message>
        <message>
            <source>an arc takes R1 and Y, or R2 and Y</source>
            <translation>圆弧需要 R1 和 Y，或 R2 和 Y</translation>
        </message>
        <message>
            <source>an array</source>
            <translation>数组</translation>
        </message>
        <message>
            <source>an array of two numbers</source>
            <translation>两个数的数组</translation>
        </message>
        <message>
            <source>an axis word stands beside %1</source>
            <translation>轴字与 %1 同段</translation>
        </message>
        <message>
            <source>an expression stands here without a letter</source>
            <translation>此处的表达式没有字母</translation>
        </message>
        <message>
            <source>an input cannot be on pin %1, which is an output; use pin 10 to 13 or 15</source>
            <translation>输入不能接在引脚 %1，它是输出；请用引脚 10 到 13 或 15</translation>
        </message>
        <message>
            <source>an offset beyond 1 000 000 000 mm or degrees</source>
            <translation>偏置超出 1 000 000 000 mm 或度</translation>
        </message>
        <message>
            <source>an optional stop (M1); Resume goes on</source>
            <translation>选择停止（M1）；按“继续”接着运行</translation>
        </message>
        <message>
            <source>an output cannot be on pin %1, which is an input; use pin 1 to 9, 14, 16 or 17</source>
            <translation>输出不能接在引脚 %1，它是输入；请用引脚 1 到 9、14、16 或 17</translation>
        </message>
        <message>
            <source>an output is being tested; end the test first</source>
            <translation>正在测试一个输出；请先结束测试</translation>
        </message>
        <message>
            <source>another code stands beside %1</source>
            <translation>另一代码与 %1 同段</translation>
        </message>
        <message>
            <source>another job was carved last</source>
            <translation>上次雕刻的是另一个作业</translation>
        </message>
        <message>
            <source>another job was published meanwhile; publish this one again</source>
            <translation>其间发布了另一个作业；请重新发布此作业</translation>
        </message>
        <message>
            <source>another process has the pins recorded, or this core cannot record them</source>
            <translation>另一进程正在记录引脚，或此内核不能记录</translation>
        </message>
        <message>
            <source>another process has the work offsets, as the one that runs a program has; wait for its end, or stop it</source>
            <translation>工件偏置被另一进程占用，例如正在运行程序的进程；请等它结束，或停止它</translation>
        </message>
        <message>
            <source>another program is being sent (process %1); wait for its end</source>
            <translation>正在发送另一个程序（进程 %1）；请等它结束</translation>
        </message>
        <message>
            <source>another run than that of the layer's first point</source>
            <translation>run 与该层第一点的不同</translation>
        </message>
        <message>
            <source>any processor</source>
            <translation>任意处理器</translation>
        </message>
        <message>
            <source>any program may keep the tick waiting; a real machine is refused</source>
            <translation>任何程序都可能让节拍等待；拒绝驱动真实机床</translation>
        </message>
        <message>
            <source>arc, from the head's + to Y's +</source>
            <translation>圆弧，从刀头正向到 Y 正向</translation>
        </message>
        <message>
            <source>arc, the other way</source>
            <translation>圆弧，反方向</translation>
        </message>
        <message>
            <source>as at the last</source>
            <translation>同上一条</translation>
        </message>
        <message>
            <source>as in the file</source>
            <translation>与文件相同</translation>
        </message>
        <message>
            <source>as it is</source>
            <translation>原样</translation>
        </message>
        <message>
            <source>as its shape</source>
            <translation>按比例</translation>
        </message>
        <message>
            <source>as planned</source>
            <translation>按计划</translation>
        </message>
        <message>
            <source>as the blank</source>
            <translation>按毛坯</translation>
        </message>
        <message>
            <source>as the profile</source>
            <translation>按配置</translation>
        </message>
        <message>
            <source>assumed</source>
            <translation>假定</translation>
        </message>
        <message>
            <source>at X %1 C %2 mm the tip of %3 comes to %4 mm, and the core that it must not reach ends at %5 mm</source>
            <translation>在 X %1 C %2 mm 处 %3 的刀尖到达 %4 mm，而不得进入的芯部止于 %5 mm</translation>
        </message>
        <message>
            <source>at X %1 C %2 mm the way passes the axis</source>
            <translation>在 X %1 C %2 mm 处路径经过轴线</translation>
        </message>
        <message>
            <source>at least %1</source>
            <translation>至少 %1</translation>
        </message>
        <message>
            <source>at most %1 KiB</source>
            <translation>最多 %1 KiB</translation>
        </message>
        <message>
            <source>auto</source>
            <translation>自动</translation>
        </message>
        <message>
            <source>axes or surface</source>
            <translation>axes 或 surface</translation>
        </message>
        <message>
            <source>axis %1</source>
            <translation>轴 %1</translation>
        </message>
        <message>
            <source>axis %1 would need %2 pulses/s, but the tick and the pulse times allow %3 pulses/s; lower it to %4, or shorten tick.period_us, port.step_high_ns or port.step_low_ns</source>
            <translation>轴 %1 需要 %2 脉冲/s，但节拍和脉冲时间只允许 %3 脉冲/s；请降到 %4，或缩短 tick.period_us、port.step_high_ns 或 port.step_low_ns</translation>
        </message>
        <message>
            <source>axis %1 would need %2 pulses/s, but the two-timer schedule allows %3 pulses/s; lower it to %4, or shorten tick.io_us</source>
            <translation>轴 %1 需要 %2 脉冲/s，但 two-timer 方式只允许 %3 脉冲/s；请降到 %4，或缩短 tick.io_us</translation>
        </message>
        <message>
            <source>back-off</source>
            <translation>退离开关</translation>
        </message>
        <message>
            <source>backing off</source>
            <translation>退离开关中</translation>
        </message>
        <message>
            <source>ball</source>
            <translation>球头</translation>
        </message>
        <message>
            <source>be in the group that owns it: adduser USER %1, and a new login</source>
            <translation>加入其所属的组：adduser USER %1，然后重新登录</translation>
        </message>
        <message>
            <source>became shorter while it was read</source>
            <translation>读取时文件变短</translation>
        </message>
        <message>
            <source>before finishing</source>
            <translation>精加工之前</translation>
        </message>
        <message>
            <source>begin and end of the arc are not equally far from its centre, or it is too small</source>
            <translation>圆弧的起点和终点到圆心的距离不相等，或圆弧太小</translation>
        </message>
        <message>
            <source>begin and end with one number or name, one block within the other</source>
            <translation>请用同一编号或名称开始和结束，程序块逐层嵌套</translation>
        </message>
        <message>
            <source>being made</source>
            <translation>正在生成</translation>
        </message>
        <message>
            <source>being published</source>
            <translation>正在发布</translation>
        </message>
        <message>
            <source>being read</source>
            <translation>正在读取</translation>
        </message>
        <message>
            <source>being sliced</source>
            <translation>正在切片</translation>
        </message>
        <message>
            <source>beyond the machine's limits</source>
            <translation>超出机床的极限</translation>
        </message>
        <message>
            <source>blank</source>
            <translation>毛坯</translation>
        </message>
        <message>
            <source>blank ⌀ %1 mm</source>
            <translation>毛坯 ⌀ %1 mm</translation>
        </message>
        <message>
            <source>blended</source>
            <translation>平滑</translation>
        </message>
        <message>
            <source>bodies inside out: %1</source>
            <translation>内外翻转的实体：%1</translation>
        </message>
        <message>
            <source>both ways between the marks are needed</source>
            <translation>需要两个标记间的两个距离</translation>
        </message>
        <message>
            <source>box centre</source>
            <translation>包围盒中心</translation>
        </message>
        <message>
            <source>brackets and signs in 64 levels</source>
            <translation>括号和正负号达 64 层</translation>
        </message>
        <message>
            <source>bring X and C to known places first, with X 0 on the axis, no rotation and both tips of one X alike</source>
            <translation>请先把 X 和 C 移到已知位置：X 0 在轴线上，无旋转，同一 X 的两个刀尖一致</translation>
        </message>
        <message>
            <source>built-in profile</source>
            <translation>内置配置</translation>
        </message>
        <message>
            <source>can be kept shallow</source>
            <translation>可保持浅休眠</translation>
        </message>
        <message>
            <source>cannot be opened: %1</source>
            <translation>无法打开：%1</translation>
        </message>
        <message>
            <source>cannot be read: %1</source>
            <translation>无法读取：%1</translation>
        </message>
        <message>
            <source>cannot be written</source>
            <translation>无法写入</translation>
        </message>
        <message>
            <source>carries no job; open its job first</source>
            <translation>不带作业；请先打开它的作业</translation>
        </message>
        <message>
            <source>carries several jobs; open the one that is meant</source>
            <translation>带有多个作业；请打开所指的那一个</translation>
        </message>
        <message>
            <source>carved</source>
            <translation>已雕刻</translation>
        </message>
        <message>
            <source>carved (%1 layers not seen: as planned)</source>
            <translation>已雕刻（%1 层未观察到：按计划）</translation>
        </message>
        <message>
            <source>carved to the last point</source>
            <translation>已雕刻到最后一点</translation>
        </message>
        <message>
            <source>carved, as planned</source>
            <translation>已雕刻，按计划</translation>
        </message>
        <message>
            <source>carving</source>
            <translation>雕刻中</translation>
        </message>
        <message>
            <source>catching up</source>
            <translation>画面正在追赶</translation>
        </message>
        <message>
            <source>catching up: %1 layers</source>
            <translation>画面正在追赶：还有 %1 层</translation>
        </message>
        <message>
            <source>centroid</source>
            <translation>形心</translation>
        </message>
        <message>
            <source>checked</source>
            <translation>已检查</translation>
        </message>
        <message>
            <source>clipping and masks are not followed: &lt;%1&gt; is carved whole.</source>
            <translation>裁剪和蒙版不起作用：&lt;%1&gt; 将整体加工。</translation>
        </message>
        <message>
            <source>clock</source>
            <translation>时钟</translation>
        </message>
        <message>
            <source>close every [ with ], and every &lt; of a name with &gt;</source>
            <translation>请用 ] 结束每个 [，用 &gt; 结束名称的每个 &lt;</translation>
        </message>
        <message>
            <source>closed, all facets turned alike</source>
            <translation>封闭，所有面朝向一致</translation>
        </message>
        <message>
            <source>column %1: %2 mm, but the heads clear no more than %3 mm</source>
            <translation>列 %1：%2 mm，但刀头最多只能避开 %3 mm</translation>
        </message>
        <message>
            <source>column %1: a pass has no such length</source>
            <translation>列 %1：一道加工不可能有这样的尺寸</translation>
        </message>
        <message>
            <source>computer</source>
            <translation>计算机</translation>
        </message>
        <message>
            <source>content of the model's file</source>
            <translation>模型文件内容</translation>
        </message>
        <message>
            <source>continuous</source>
            <translation>连续</translation>
        </message>
        <message>
            <source>continuous, zigzag or spiral</source>
            <translation>continuous、zigzag 或 spiral</translation>
        </message>
        <message>
            <source>core lost</source>
            <translation>内核丢失</translation>
        </message>
        <message>
            <source>counter-clockwise, seen from the axis' positive end</source>
            <translation>逆时针，从轴的正端看</translation>
        </message>
        <message>
            <source>cpupower frequency-set --governor performance (package linux-cpupower)</source>
            <translation>cpupower frequency-set --governor performance（软件包 linux-cpupower）</translation>
        </message>
        <message>
            <source>cut off</source>
            <translation>被截断</translation>
        </message>
        <message>
            <source>cut off, or not an STL file: the header announces %1 facets, the file has room for %2</source>
            <translation>文件被截断，或不是 STL：文件头声明 %1 个面，文件只容得下 %2 个</translation>
        </message>
        <message>
            <source>cut off: a binary STL begins with 84 bytes, the file has %1</source>
            <translation>文件被截断：二进制 STL 以 84 字节开头，文件只有 %1</translation>
        </message>
        <message>
            <source>cut off: it ends without endsolid, and the mesh has holes</source>
            <translation>文件被截断：结尾没有 endsolid，且网格有孔</translation>
        </message>
        <message>
            <source>cut off: its header is not complete</source>
            <translation>文件被截断：文件头不完整</translation>
        </message>
        <message>
            <source>cut off: the PLY header has no end_header</source>
            <translation>文件被截断：PLY 文件头没有 end_header</translation>
        </message>
        <message>
            <source>damaged: its checksum is wrong</source>
            <translation>已损坏：校验和错误</translation>
        </message>
        <message>
            <source>damaged: sizes and offsets do not fit each other</source>
            <translation>已损坏：大小与偏移不符</translation>
        </message>
        <message>
            <source>docs/gcode.md says which ways run step by step</source>
            <translation>哪些路径逐步运行见 docs/gcode.md</translation>
        </message>
        <message>
            <source>done</source>
            <translation>完成</translation>
        </message>
        <message>
            <source>doubled: %1</source>
            <translation>重复：%1</translation>
        </message>
        <message>
            <source>draw arcs in Y and one head: G17 or G19, with the letters of lathes G18</source>
            <translation>圆弧请用 Y 和一个刀头：G17 或 G19，车床字母时用 G18</translation>
        </message>
        <message>
            <source>drive a real machine from a real computer</source>
            <translation>请用真实计算机驱动真实机床</translation>
        </message>
        <message>
            <source>drives off</source>
            <translation>驱动已关闭</translation>
        </message>
        <message>
            <source>drives-off</source>
            <translation>关闭驱动</translation>
        </message>
        <message>
            <source>dry run to the last point: nothing was carved</source>
            <translation>空运行到最后一点：未雕刻</translation>
        </message>
        <message>
            <source>edges between flipped facets: %1</source>
            <translation>翻转面之间的边：%1</translation>
        </message>
        <message>
            <source>emergency stop</source>
            <translation>急停</translation>
        </message>
        <message>
            <source>emergency stop by the operator</source>
            <translation>操作员急停</translation>
        </message>
        <message>
            <source>end the block before the program ends</source>
            <translation>请在程序结束前结束程序块</translation>
        </message>
        <message>
            <source>end the comment with ) on its line</source>
            <translation>请在同一行用 ) 结束注释</translation>
        </message>
        <message>
            <source>end the mode first, with G7.1 C0 or G13.1</source>
            <translation>请先用 G7.1 C0 或 G13.1 结束该方式</translation>
        </message>
        <message>
            <source>end the program that holds it; psicarve status shows a core</source>
            <translation>结束占用它的程序；psicarve status 可显示内核</translation>
        </message>
        <message>
            <source>end the program with M2 or M30, or frame it with two lines of %</source>
            <translation>请用 M2 或 M30 结束程序，或用两行 % 括起</translation>
        </message>
        <message>
            <source>ended at layer %1 of %2</source>
            <translation>结束于第 %1 层，共 %2 层</translation>
        </message>
        <message>
            <source>ended by an alarm</source>
            <translation>因报警结束</translation>
        </message>
        <message>
            <source>entries of the flight recorder</source>
            <translation>飞行记录条目数</translation>
        </message>
        <message>
            <source>feed</source>
            <translation>进给</translation>
        </message>
        <message>
            <source>feed %1 %</source>
            <translation>进给 %1 %</translation>
        </message>
        <message>
            <source>feed %1 mm/s</source>
            <translation>进给 %1 mm/s</translation>
        </message>
        <message>
            <source>feed [mm/s]</source>
            <translation>进给 [mm/s]</translation>
        </message>
        <message>
            <source>file version %1, this program knows %2: make the file anew</source>
            <translation>文件版本 %1，本程序支持 %2：请重新生成文件</translation>
        </message>
        <message>
            <source>file's origin</source>
            <translation>文件原点</translation>
        </message>
        <message>
            <source>finishing</source>
            <translation>收尾中</translation>
        </message>
        <message>
            <source>finishing only</source>
            <translation>只做精加工</translation>
        </message>
        <message>
            <source>finishing pass</source>
            <translation>精加工</translation>
        </message>
        <message>
            <source>fit a parallel port; modprobe parport_pc ppdev</source>
            <translation>装上并口；modprobe parport_pc ppdev</translation>
        </message>
        <message>
            <source>flat</source>
            <translation>平头</translation>
        </message>
        <message>
            <source>flight recorder, entry %1, counted from 0</source>
            <translation>飞行记录第 %1 条（从 0 计）</translation>
        </message>
        <message>
            <source>forget</source>
            <translation>忘记</translation>
        </message>
        <message>
            <source>free</source>
            <translation>空闲</translation>
        </message>
        <message>
            <source>from here on a tick may have been missed</source>
            <translation>从此处起可能丢失节拍</translation>
        </message>
        <message>
            <source>from standard input</source>
            <translation>来自标准输入</translation>
        </message>
        <message>
            <source>from the pins</source>
            <translation>由引脚得出</translation>
        </message>
        <message>
            <source>give --cpu the number of a processor that this process may use, or any</source>
            <translation>给 --cpu 指定本进程可用的处理器编号，或 any</translation>
        </message>
        <message>
            <source>give F before the first move that cuts</source>
            <translation>请在第一个切削运动之前给出 F</translation>
        </message>
        <message>
            <source>give F in every such block while G93 holds</source>
            <translation>G93 有效时请在每个这样的程序段中给出 F</translation>
        </message>
        <message>
            <source>give G0, G1, G2 or G3 first</source>
            <translation>请先给出 G0、G1、G2 或 G3</translation>
        </message>
        <message>
            <source>give G7.1 with its C, G12.1 and G13.1 a block of their own</source>
            <translation>请把 G7.1 及其 C、G12.1 和 G13.1 放在单独的程序段</translation>
        </message>
        <message>
            <source>give R half the way to the end at least</source>
            <translation>R 至少应为到终点距离的一半</translation>
        </message>
        <message>
            <source>give S first, or use G94</source>
            <translation>请先给出 S，或使用 G94</translation>
        </message>
        <message>
            <source>give a value that the word can have</source>
            <translation>请给出该字允许的值</translation>
        </message>
        <message>
            <source>give an O word a line of its own</source>
            <translation>请让 O 字单独成行</translation>
        </message>
        <message>
            <source>give centre and end with more digits</source>
            <translation>请用更多位数给出圆心和终点</translation>
        </message>
        <message>
            <source>give each subroutine its own number or name</source>
            <translation>请给每个子程序各自的编号或名称</translation>
        </message>
        <message>
            <source>give it a value that can be calculated</source>
            <translation>请给出可以计算的值</translation>
        </message>
        <message>
            <source>give one code of a modal group in a block</source>
            <translation>一个程序段中每个模态组只给一个代码</translation>
        </message>
        <message>
            <source>give the centre in the plane's two words, or R alone</source>
            <translation>请用该平面的两个字给出圆心，或只用 R</translation>
        </message>
        <message>
            <source>give the centre with two of I, J and K, or the radius with R</source>
            <translation>请用 I、J、K 中的两个给出圆心，或用 R 给出半径</translation>
        </message>
        <message>
            <source>give the centre: R does not tell where a whole circle lies</source>
            <translation>请给出圆心：R 不能确定整圆的位置</translation>
        </message>
        <message>
            <source>give the core real-time rights, lengthen tick.period_us or raise tick.missed_alarm_per_s</source>
            <translation>给内核实时权限，加长 tick.period_us 或提高 tick.missed_alarm_per_s</translation>
        </message>
        <message>
            <source>give the length itself with G43.1</source>
            <translation>请用 G43.1 直接给出长度</translation>
        </message>
        <message>
            <source>give the letter once in a block</source>
            <translation>每个字母在程序段中只给一次</translation>
        </message>
        <message>
            <source>granted</source>
            <translation>已授予</translation>
        </message>
        <message>
            <source>grooves %1 mm deep and %2 mm wide; where no point meets the line, up to %3 mm wider along the layers and %4 mm across them</source>
            <translation>刻槽深 %1 mm，宽 %2 mm；没有点落在线上处，沿层方向最多宽出 %3 mm，跨层方向最多宽出 %4 mm</translation>
        </message>
        <message>
            <source>grooves %1 mm deep; they must be deeper than 0, and less deep than the cylinder's radius of %2 mm</source>
            <translation>刻槽深 %1 mm；必须大于 0，且小于圆柱半径 %2 mm</translation>
        </message>
        <message>
            <source>ground</source>
            <translation>地</translation>
        </message>
        <message>
            <source>guard lost</source>
            <translation>守护丢失</translation>
        </message>
        <message>
            <source>has been changed since it was read; decode it again</source>
            <translation>读取后已更改；请重新解析</translation>
        </message>
        <message>
            <source>has been changed while it is run; what was read of it before is run</source>
            <translation>运行期间文件被更改；只运行此前读取的部分</translation>
        </message>
        <message>
            <source>has no closed outline; the longest stroke goes from %1 to %2 mm, %3 apart; close it in the drawing program</source>
            <translation>没有闭合轮廓；最长的线从 %1 到 %2 mm，相距 %3；请在绘图软件中闭合</translation>
        </message>
        <message>
            <source>heap kept</source>
            <translation>堆内存保留</translation>
        </message>
        <message>
            <source>height</source>
            <translation>高度</translation>
        </message>
        <message>
            <source>heights: %1 layers differ, the first is layer %2, counted from 0</source>
            <translation>高度：%1 层不同，首个为第 %2 层（从 0 计）</translation>
        </message>
        <message>
            <source>held</source>
            <translation>已暂停</translation>
        </message>
        <message>
            <source>held by %1</source>
            <translation>被 %1 占用</translation>
        </message>
        <message>
            <source>high</source>
            <translation>高</translation>
        </message>
        <message>
            <source>high or low</source>
            <translation>high 或 low</translation>
        </message>
        <message>
            <source>hold</source>
            <translation>暂停</translation>
        </message>
        <message>
            <source>holding</source>
            <translation>减速暂停中</translation>
        </message>
        <message>
            <source>holds no facets (%1)</source>
            <translation>没有任何面（%1）</translation>
        </message>
        <message>
            <source>holds no job</source>
            <translation>不含作业</translation>
        </message>
        <message>
            <source>holds no line that can be carved (%1)</source>
            <translation>没有可雕刻的线条（%1）</translation>
        </message>
        <message>
            <source>holes: %1, open edges: %2</source>
            <translation>孔洞：%1，开放边：%2</translation>
        </message>
        <message>
            <source>home</source>
            <translation>回零</translation>
        </message>
        <message>
            <source>home ?</source>
            <translation>零位 ?</translation>
        </message>
        <message>
            <source>home failed</source>
            <translation>回零失败</translation>
        </message>
        <message>
            <source>home first</source>
            <translation>请先回零</translation>
        </message>
        <message>
            <source>homed</source>
            <translation>已回零</translation>
        </message>
        <message>
            <source>homing</source>
            <translation>回零中</translation>
        </message>
        <message>
            <source>in</source>
            <translation>入</translation>
        </message>
        <message>
            <source>in force</source>
            <translation>已生效</translation>
        </message>
        <message>
            <source>in it</source>
            <translation>已包含</translation>
        </message>
        <message>
            <source>inches</source>
            <translation>英寸</translation>
        </message>
        <message>
            <source>index or none</source>
            <translation>index 或 none</translation>
        </message>
        <message>
            <source>info</source>
            <translation>信息</translation>
        </message>
        <message>
            <source>inside out</source>
            <translation>内外翻转</translation>
        </message>
        <message>
            <source>install a real-time kernel: apt install linux-image-rt-amd64</source>
            <translation>安装实时内核：apt install linux-image-rt-amd64</translation>
        </message>
        <message>
            <source>interrupted; nothing has moved</source>
            <translation>已中断；没有任何移动</translation>
        </message>
        <message>
            <source>is a folder, not a model file</source>
            <translation>是文件夹，不是模型文件</translation>
        </message>
        <message>
            <source>is a folder; choose a program</source>
            <translation>是文件夹；请选择程序</translation>
        </message>
        <message>
            <source>is a zip archive, but holds no 3MF model</source>
            <translation>是 zip 压缩包，但不含 3MF 模型</translation>
        </message>
        <message>
            <source>is counted from the blank's surface, and nobody knows where that is; set blank.radius_mm</source>
            <translation>从毛坯表面算起，而表面位置未知；请设 blank.radius_mm</translation>
        </message>
        <message>
            <source>is no 3MF file: these are zip archives</source>
            <translation>不是 3MF 文件：3MF 是 zip 压缩包</translation>
        </message>
        <message>
            <source>is no psicarve job or snapshot file</source>
            <translation>不是 psicarve 的作业或快照文件</translation>
        </message>
        <message>
            <source>is no regular file, and is read twice</source>
            <translation>不是普通文件，而程序要读取两遍</translation>
        </message>
        <message>
            <source>is not a regular file</source>
            <translation>不是普通文件</translation>
        </message>
        <message>
            <source>is not wired, but %1 = %2 needs it; give its pin, or set %3 = "none"</source>
            <translation>未接线，但 %1 = %2 需要它；请给出引脚，或设 %3 = "none"</translation>
        </message>
        <message>
            <source>is not wired, so axis %1 cannot move; give its pin</source>
            <translation>未接线，轴 %1 因此不能移动；请给出引脚</translation>
        </message>
        <message>
            <source>isolated: %1; the tick takes %2</source>
            <translation>已隔离：%1；节拍使用 %2</translation>
        </message>
        <message>
            <source>it has a character that is none to print; remove it</source>
            <translation>含有不可显示的字符；请删除</translation>
        </message>
        <message>
            <source>it said nothing</source>
            <translation>它没有说明</translation>
        </message>
        <message>
            <source>it was stopped in line %1; it can go on from there</source>
            <translation>已在第 %1 行停止；可从该行继续</translation>
        </message>
        <message>
            <source>its &lt;use&gt; elements draw more than two million elements</source>
            <translation>其 &lt;use&gt; 元素绘出超过两百万个元素</translation>
        </message>
        <message>
            <source>its blocks draw more than a million elements</source>
            <translation>其块绘出超过一百万个元素</translation>
        </message>
        <message>
            <source>its blocks draw more than half a gigabyte of text</source>
            <translation>其块展开后超过半吉字节的文本</translation>
        </message>
        <message>
            <source>its grooves are of another tool</source>
            <translation>其刻槽属于另一把刀具</translation>
        </message>
        <message>
            <source>its host takes the processor away when it likes, and nothing here can prevent that</source>
            <translation>宿主机随时会取走处理器，此处无法阻止</translation>
        </message>
        <message>
            <source>its next lines have not come; it goes on when they do</source>
            <translation>后面的行尚未到达；到达后自动继续</translation>
        </message>
        <message>
            <source>its outlines cannot be joined: %1</source>
            <translation>其轮廓无法合并：%1</translation>
        </message>
        <message>
            <source>its outlines enclose no area; there is nothing to carve</source>
            <translation>其轮廓不围成面积；没有可雕刻的内容</translation>
        </message>
        <message>
            <source>its reader is gone</source>
            <translation>读取进程已消失</translation>
        </message>
        <message>
            <source>its reader was gone</source>
            <translation>读取程序的进程当时已消失</translation>
        </message>
        <message>
            <source>job</source>
            <translation>作业</translation>
        </message>
        <message>
            <source>jog</source>
            <translation>点动</translation>
        </message>
        <message>
            <source>joining</source>
            <translation>连接方式</translation>
        </message>
        <message>
            <source>journal of the machine, run %1</source>
            <translation>机床日志，第 %1 次运行</translation>
        </message>
        <message>
            <source>journal of the simulator, run %1</source>
            <translation>模拟器日志，第 %1 次运行</translation>
        </message>
        <message>
            <source>keep the tip further out</source>
            <translation>请让刀尖更靠外</translation>
        </message>
        <message>
            <source>keep the two tips further apart</source>
            <translation>请让两个刀尖离得更远</translation>
        </message>
        <message>
            <source>kernel</source>
            <translation>操作系统内核</translation>
        </message>
        <message>
            <source>larger than the machine's travel: axis %1 would have to go to %2 mm, allowed are %3; choose a smaller height</source>
            <translation>大于机床行程：%1 轴需到 %2 mm，允许范围 %3；请选较小的高度</translation>
        </message>
        <message>
            <source>last known</source>
            <translation>最后已知</translation>
        </message>
        <message>
            <source>last known %1</source>
            <translation>最后已知 %1</translation>
        </message>
        <message>
            <source>layer %1 lies no higher than the one before</source>
            <translation>第 %1 层不高于前一层</translation>
        </message>
        <message>
            <source>layer %1 lies no higher than the one before: a table of several passes needs the columns run to clear_mm; export the job again</source>
            <translation>第 %1 层不高于前一层：多道加工的表格需要 run 至 clear_mm 各列；请重新导出作业</translation>
        </message>
        <message>
            <source>layer %1, point %2: a radius of %3 mm, less than core_radius_mm, %4 mm</source>
            <translation>第 %1 层第 %2 点：半径 %3 mm，小于 core_radius_mm（%4 mm）</translation>
        </message>
        <message>
            <source>layer %1, point %2: axis %3 would have to go to %4 mm, but goes from %5 mm to %6 mm</source>
            <translation>第 %1 层第 %2 点：%3 轴须移至 %4 mm，而行程为 %5 mm 至 %6 mm</translation>
        </message>
        <message>
            <source>layer %1, point %2: psi is not where any joining has it</source>
            <translation>第 %1 层，第 %2 点：Ψ 不符合任何一种连接方式的位置</translation>
        </message>
        <message>
            <source>layer %1, point %2: the height is neither its layer's nor on a spiral's way up</source>
            <translation>第 %1 层第 %2 点：高度既不是该层的高度，也不在螺旋的上升路线上</translation>
        </message>
        <message>
            <source>layer %1, point %2: the radius of %3 is not that in which the layer below ends; slice the model again</source>
            <translation>第 %1 层，第 %2 点：%3 的半径与下方一层末端的半径不同；请重新切片</translation>
        </message>
        <message>
            <source>layer %1, point %2: the radius of %3, %4, is beyond the travel, which ends at %5; make the model smaller</source>
            <translation>第 %1 层，第 %2 点：%3 的半径 %4 超出行程，行程止于 %5；请缩小模型</translation>
        </message>
        <message>
            <source>layer %1, point %2: the radius of %3, %4, is inside the core radius of %5; carve less deep, or lower core_radius_mm</source>
            <translation>第 %1 层第 %2 点：%3 的半径 %4 在芯半径 %5 之内；请雕浅一些，或减小 core_radius_mm</translation>
        </message>
        <message>
            <source>layer %1, point %2: the tips are %3 apart, closer than head_clearance_mm, %4; raise core_radius_mm and slice again</source>
            <translation>第 %1 层，第 %2 点：刀尖相距 %3，小于 head_clearance_mm（%4）；请增大 core_radius_mm 并重新切片</translation>
        </message>
        <message>
            <source>layer %1: the height of %2 does not lie above the layer below, %3; use fewer layers</source>
            <translation>第 %1 层：高度 %2 不高于下方一层的 %3；请减少层数</translation>
        </message>
        <message>
            <source>layer %1: the height of %2 is not that of the layer below, %3, as in the ring that closes a spiral; slice the model again</source>
            <translation>第 %1 层：高度 %2 与下方一层的 %3 不同，而闭合螺旋的环应相同；请重新切片</translation>
        </message>
        <message>
            <source>layer %1: the height of %2 lies outside the travel of Y, %3 to %4; make the model smaller</source>
            <translation>第 %1 层：高度 %2 超出 Y 的行程 %3 到 %4；请缩小模型</translation>
        </message>
        <message>
            <source>layers</source>
            <translation>层数</translation>
        </message>
        <message>
            <source>layers %1 to %2</source>
            <translation>第 %1 至 %2 层</translation>
        </message>
        <message>
            <source>layers %1 to %2, from point %3 on</source>
            <translation>第 %1 至 %2 层，从第 %3 点起</translation>
        </message>
        <message>
            <source>layers do not count on by one</source>
            <translation>层号不连续</translation>
        </message>
        <message>
            <source>least blank ⌀ %1 mm</source>
            <translation>最小毛坯 ⌀ %1 mm</translation>
        </message>
        <message>
            <source>least lost</source>
            <translation>损失最少</translation>
        </message>
        <message>
            <source>leave the parameter as it is: only the machine sets it</source>
            <translation>请勿改动该参数：只有机床设置它</translation>
        </message>
        <message>
            <source>left</source>
            <translation>左</translation>
        </message>
        <message>
            <source>left out: %1</source>
            <translation>舍去：%1</translation>
        </message>
        <message>
            <source>let the CAM system compensate: a radial tool has no side</source>
            <translation>请由 CAM 系统补偿：径向刀具没有左右之分</translation>
        </message>
        <message>
            <source>let the CAM system write it out in plain words</source>
            <translation>请让 CAM 系统用普通字写出</translation>
        </message>
        <message>
            <source>let the CAM system write the blocks out, or take fewer passes</source>
            <translation>请让 CAM 系统写出各程序段，或减少循环次数</translation>
        </message>
        <message>
            <source>let the loop end, or move in it</source>
            <translation>请让循环结束，或在其中运动</translation>
        </message>
        <message>
            <source>lies wholly within the core radius of %1 mm: nothing but a plain rod would be carved; it is %2 large: are its units inches? Height makes it larger</source>
            <translation>完全位于芯半径 %1 mm 之内：只会雕出一根光杆；其大小为 %2：单位是英寸吗？可用“高度”放大</translation>
        </message>
        <message>
            <source>lies wholly within the core radius of %1 mm: nothing but a plain rod would be carved; it is %2 large: are its units metres? Height makes it larger</source>
            <translation>完全位于芯半径 %1 mm 之内：只会雕出一根光杆；其大小为 %2：单位是米吗？可用“高度”放大</translation>
        </message>
        <message>
            <source>lies wholly within the core radius of %1 mm: nothing but a plain rod would be carved; it is %2 large: make it larger, or core_radius_mm smaller</source>
            <translation>完全位于芯半径 %1 mm 之内：只会雕出一根光杆；其大小为 %2：请放大，或减小 core_radius_mm</translation>
        </message>
        <message>
            <source>lies wholly within the radius of %1 mm at which the heads' travel ends: nothing but a plain rod would be carved; it is %2 large: are its units inches? Height makes it larger</source>
            <translation>完全位于刀头行程终点的半径 %1 mm 之内：只会雕出一根光杆；其大小为 %2：单位是英寸吗？可用“高度”放大</translation>
        </message>
        <message>
            <source>lies wholly within the radius of %1 mm at which the heads' travel ends: nothing but a plain rod would be carved; it is %2 large: are its units metres? Height makes it larger</source>
            <translation>完全位于刀头行程终点的半径 %1 mm 之内：只会雕出一根光杆；其大小为 %2：单位是米吗？可用“高度”放大</translation>
        </message>
        <message>
            <source>lies wholly within the radius of %1 mm at which the heads' travel ends: nothing but a plain rod would be carved; it is %2 large: make it larger, or let travel_mm go further in</source>
            <translation>完全位于刀头行程终点的半径 %1 mm 之内：只会雕出一根光杆；其大小为 %2：请放大，或让 travel_mm 更靠内</translation>
        </message>
        <message>
            <source>lift or stay</source>
            <translation>lift 或 stay</translation>
        </message>
        <message>
            <source>limit</source>
            <translation>限位</translation>
        </message>
        <message>
            <source>line %1</source>
            <translation>第 %1 行</translation>
        </message>
        <message>
            <source>line %1 has more than 64 MiB: this is no program in G-code</source>
            <translation>第 %1 行超过 64 MiB：这不是 G 代码程序</translation>
        </message>
        <message>
            <source>line %1: %2 cannot count so far</source>
            <translation>第 %1 行：%2 无法计数到那么远</translation>
        </message>
        <message>
            <source>line %1: %2 is not wired to any pin; give its pin in the profile</source>
            <translation>第 %1 行：%2 未接到任何引脚；请在配置中指定其引脚</translation>
        </message>
        <message>
            <source>line %1: %2 would come to %3, inside the core radius of %4; carve less deep</source>
            <translation>第 %1 行：%2 将到达 %3，在芯半径 %4 之内；请雕浅一些</translation>
        </message>
        <message>
            <source>line %1: %2 would come to %3, its travel is %4 to %5; move the work offset</source>
            <translation>第 %1 行：%2 将到达 %3，其行程为 %4 至 %5；请移动工件偏置</translation>
        </message>
        <message>
            <source>line %1: it is not known where %2 begins</source>
            <translation>第 %1 行：不知道 %2 从何处开始</translation>
        </message>
        <message>
            <source>line %1: it would take more than %2 ms; change its feed or its dwell</source>
            <translation>第 %1 行：耗时将超过 %2 ms；请更改进给或停留时间</translation>
        </message>
        <message>
            <source>line %1: its ends are not as far from the arc's centre as each other; start it again</source>
            <translation>第 %1 行：两端到圆弧圆心的距离不相等；请重新启动</translation>
        </message>
        <message>
            <source>line %1: the core does not know what this line asks for; is it another version?</source>
            <translation>第 %1 行：内核不认识此行的要求；是否版本不同？</translation>
        </message>
        <message>
            <source>line %1: the program does not reach the core as it was read; start it again</source>
            <translation>第 %1 行：程序没有原样到达内核；请重新启动程序</translation>
        </message>
        <message>
            <source>line %1: the program goes on after its end</source>
            <translation>第 %1 行：程序在其结尾之后仍在继续</translation>
        </message>
        <message>
            <source>line %1: the tips would be %2 apart, closer than head_clearance_mm, %3; carve less deep</source>
            <translation>第 %1 行：刀尖将相距 %2，小于 head_clearance_mm（%3）；请雕浅一些</translation>
        </message>
        <message>
            <source>line %1: the tips, %2 apart at one end, would pass each other closer than head_clearance_mm, %3; move one head after the other</source>
            <translation>第 %1 行：刀尖在一端相距 %2，途中将近于 head_clearance_mm（%3）；请让两个刀头先后移动</translation>
        </message>
        <message>
            <source>line %1: the tolerance %2 is not between 0 and %3; change the P of G64</source>
            <translation>第 %1 行：公差 %2 不在 0 与 %3 之间；请更改 G64 的 P</translation>
        </message>
        <message>
            <source>linear</source>
            <translation>直线</translation>
        </message>
        <message>
            <source>lines are engraved once they are sliced</source>
            <translation>线条切片后才会雕刻</translation>
        </message>
        <message>
            <source>loaded</source>
            <translation>已加载</translation>
        </message>
        <message>
            <source>locked</source>
            <translation>锁定</translation>
        </message>
        <message>
            <source>locked memory</source>
            <translation>锁定内存</translation>
        </message>
        <message>
            <source>lookahead or angle</source>
            <translation>lookahead 或 angle</translation>
        </message>
        <message>
            <source>looking for the best axis was cancelled</source>
            <translation>已取消寻找最佳轴线</translation>
        </message>
        <message>
            <source>loops and calls make more than %1 blocks</source>
            <translation>循环和调用超过 %1 个程序段</translation>
        </message>
        <message>
            <source>loops and subroutines of a stream have more than 64 MiB</source>
            <translation>数据流中的循环和子程序超过 64 MiB</translation>
        </message>
        <message>
            <source>low</source>
            <translation>低</translation>
        </message>
        <message>
            <source>machine or turning</source>
            <translation>machine 或 turning</translation>
        </message>
        <message>
            <source>marks %1 mm apart in height; more than %2 mm is no error of mounting. Was Y left alone?</source>
            <translation>标记高度相差 %1 mm；超过 %2 mm 不是安装误差。Y 是否没有动过？</translation>
        </message>
        <message>
            <source>marks %1 mm apart on a blank of %2 mm would be %3°; more than %4° is no error of mounting. Was the table turned by exactly half a turn?</source>
            <translation>标记相距 %1 mm，毛坯 %2 mm，即 %3°；超过 %4° 不是安装误差。转台是否正好转了半圈？</translation>
        </message>
        <message>
            <source>may not be read by this user; let the machine's group read it, or name another folder: $PSICARVE_STATE</source>
            <translation>当前用户无权读取；请允许机床所属的组读取，或指定其他文件夹：$PSICARVE_STATE</translation>
        </message>
        <message>
            <source>may not be written</source>
            <translation>不可写</translation>
        </message>
        <message>
            <source>memory locked</source>
            <translation>内存已锁定</translation>
        </message>
        <message>
            <source>memory touched</source>
            <translation>内存已预占</translation>
        </message>
        <message>
            <source>min, max or none</source>
            <translation>min、max 或 none</translation>
        </message>
        <message>
            <source>missed %1</source>
            <translation>丢失 %1</translation>
        </message>
        <message>
            <source>missed %1 of %2 a second</source>
            <translation>每秒错过 %1，允许 %2</translation>
        </message>
        <message>
            <source>missed ticks</source>
            <translation>丢失节拍</translation>
        </message>
        <message>
            <source>missing</source>
            <translation>缺少</translation>
        </message>
        <message>
            <source>mm for each unit of the file</source>
            <translation>文件每单位对应的 mm</translation>
        </message>
        <message>
            <source>model</source>
            <translation>模型</translation>
        </message>
        <message>
            <source>modprobe ppdev</source>
            <translation>modprobe ppdev</translation>
        </message>
        <message>
            <source>module lp</source>
            <translation>模块 lp</translation>
        </message>
        <message>
            <source>more layers than pulses: %1 layers, but the model is only %2 mm, %3 pulses of axis Y, high: choose at most %4 layers, or a larger height</source>
            <translation>层数多于脉冲：%1 层，但模型只有 %2 mm 高，即 Y 轴 %3 个脉冲：最多选 %4 层，或选更大的高度</translation>
        </message>
        <message>
            <source>more points than pulses: %1 points a layer, but half a turn of axis Ψ has %2 pulses: choose at most %3 points</source>
            <translation>点数多于脉冲：每层 %1 点，但 Ψ 轴半圈只有 %2 个脉冲：最多选 %3 点</translation>
        </message>
        <message>
            <source>more points than pulses: %1 points in half a turn of %2 pulses</source>
            <translation>点多于脉冲：半转有 %1 点，而只有 %2 个脉冲</translation>
        </message>
        <message>
            <source>more than %1 points when its curves are cut into straight pieces; nobody can carve that</source>
            <translation>曲线分成直线段后超过 %1 个点；无法雕刻</translation>
        </message>
        <message>
            <source>more than %1 runs, which no job has</source>
            <translation>超过 %1 段，没有作业有这么多</translation>
        </message>
        <message>
            <source>more than 10000 named parameters</source>
            <translation>命名参数超过 10000 个</translation>
        </message>
        <message>
            <source>more than 10000 subroutines</source>
            <translation>子程序超过 10000 个</translation>
        </message>
        <message>
            <source>more than 1000000000 passes</source>
            <translation>重复次数超过 1000000000</translation>
        </message>
        <message>
            <source>more than 512 MiB, which no drawing or picture needs</source>
            <translation>超过 512 MiB，图形或图片不需要这么大</translation>
        </message>
        <message>
            <source>more than a gigabyte, which no table needs</source>
            <translation>超过 1 GB，表格不需要这么大</translation>
        </message>
        <message>
            <source>more than four million values in one element</source>
            <translation>一个元素中超过四百万个值</translation>
        </message>
        <message>
            <source>mount -o remount,size=1G /dev/shm, or psicarve-rtcore --capacity for smaller jobs</source>
            <translation>mount -o remount,size=1G /dev/shm，或用 psicarve-rtcore --capacity 限制作业大小</translation>
        </message>
        <message>
            <source>mount a tmpfs there</source>
            <translation>请在那里挂载 tmpfs</translation>
        </message>
        <message>
            <source>move</source>
            <translation>移动</translation>
        </message>
        <message>
            <source>move the work offset, or the part</source>
            <translation>请移动工件偏置或工件</translation>
        </message>
        <message>
            <source>moving</source>
            <translation>移动中</translation>
        </message>
        <message>
            <source>no arc, %1 and Y differ in pulses_per_mm</source>
            <translation>不是圆弧：%1 和 Y 的 pulses_per_mm 不同</translation>
        </message>
        <message>
            <source>no axis goes so far (%1)</source>
            <translation>没有轴能走这么远（%1）</translation>
        </message>
        <message>
            <source>no axis to move</source>
            <translation>没有要移动的轴</translation>
        </message>
        <message>
            <source>no blank has %1 mm; %2 to %3 mm can be</source>
            <translation>没有 %1 mm 的毛坯；可为 %2 至 %3 mm</translation>
        </message>
        <message>
            <source>no core</source>
            <translation>无内核</translation>
        </message>
        <message>
            <source>no core has it; one that is started says whether a port is there</source>
            <translation>没有内核占用它；那里是否有端口，内核启动时会说明</translation>
        </message>
        <message>
            <source>no core serves segment %1</source>
            <translation>没有内核服务于共享段 %1</translation>
        </message>
        <message>
            <source>no function begins so</source>
            <translation>没有这样开头的函数</translation>
        </message>
        <message>
            <source>no job</source>
            <translation>无作业</translation>
        </message>
        <message>
            <source>no job is published; publish one first</source>
            <translation>没有已发布的作业；请先发布</translation>
        </message>
        <message>
            <source>no layer was finished</source>
            <translation>没有一层已雕刻完成</translation>
        </message>
        <message>
            <source>no layer was finished; start from the beginning, or with layer %1 for the piece of before</source>
            <translation>没有一层已雕刻完成；请从头开始，若是之前的工件则从第 %1 层开始</translation>
        </message>
        <message>
            <source>no lines to engrave</source>
            <translation>没有可雕刻的线条</translation>
        </message>
        <message>
            <source>no longer in the machine</source>
            <translation>已不在机床中</translation>
        </message>
        <message>
            <source>no motion is in force that uses axis words</source>
            <translation>没有使用轴字的有效运动代码</translation>
        </message>
        <message>
            <source>no parameter has this number</source>
            <translation>没有这个编号的参数</translation>
        </message>
        <message>
            <source>no pin</source>
            <translation>无引脚</translation>
        </message>
        <message>
            <source>no pin has %1 mm; %2 to %3 mm can be</source>
            <translation>没有 %1 mm 的销；可为 %2 至 %3 mm</translation>
        </message>
        <message>
            <source>no program runs</source>
            <translation>没有程序在运行</translation>
        </message>
        <message>
            <source>no radius is beyond that of %1 mm at which the heads' travel ends: nothing but a plain rod would be carved; larger radii, or a travel_mm that goes further in, carve more</source>
            <translation>没有半径超出刀头行程终点的 %1 mm：只会雕出一根光杆；请用更大的半径，或让 travel_mm 更靠内</translation>
        </message>
        <message>
            <source>no right to addresses</source>
            <translation>没有访问端口地址的权限</translation>
        </message>
        <message>
            <source>no right to addresses; --port ppdev:/dev/parport0 needs no such right</source>
            <translation>没有访问端口地址的权限；--port ppdev:/dev/parport0 不需要此权限</translation>
        </message>
        <message>
            <source>no roughing passes: nothing of the blank stands further out than the allowance</source>
            <translation>无粗加工：毛坯没有超出余量的部分</translation>
        </message>
        <message>
            <source>no such axis</source>
            <translation>没有这个轴</translation>
        </message>
        <message>
            <source>no such file</source>
            <translation>没有此文件</translation>
        </message>
        <message>
            <source>no such output</source>
            <translation>没有这个输出</translation>
        </message>
        <message>
            <source>no virtual machine</source>
            <translation>不是虚拟机</translation>
        </message>
        <message>
            <source>no. %1</source>
            <translation>%1 号</translation>
        </message>
        <message>
            <source>no. %1, %2 % done</source>
            <translation>%1 号，已完成 %2 %</translation>
        </message>
        <message>
            <source>no. %1, dry run %2 %</source>
            <translation>%1 号，空运行 %2 %</translation>
        </message>
        <message>
            <source>no: a dry run carves nothing</source>
            <translation>否：空运行不雕刻</translation>
        </message>
        <message>
            <source>no: its pins were not recorded (page Ports)</source>
            <translation>否：未记录引脚（端口页）</translation>
        </message>
        <message>
            <source>nobody holds its lease</source>
            <translation>没有人持有其租约</translation>
        </message>
        <message>
            <source>nobody knows how far it was carved; look at the piece and choose the layer</source>
            <translation>无法得知已雕刻到哪里；请查看工件并选择层</translation>
        </message>
        <message>
            <source>none</source>
            <translation>无</translation>
        </message>
        <message>
            <source>none is kept free</source>
            <translation>没有保留空闲的</translation>
        </message>
        <message>
            <source>none: add it</source>
            <translation>无：请添加</translation>
        </message>
        <message>
            <source>none: not %1</source>
            <translation>无：非 %1</translation>
        </message>
        <message>
            <source>none: ticks may be late</source>
            <translation>无：节拍可能迟滞</translation>
        </message>
        <message>
            <source>not</source>
            <translation>不镜像</translation>
        </message>
        <message>
            <source>not a picture that can be read here (PNG, JPEG, TIFF, BMP, PGM)</source>
            <translation>不是可读取的图片（PNG、JPEG、TIFF、BMP、PGM）</translation>
        </message>
        <message>
            <source>not allowed</source>
            <translation>不允许</translation>
        </message>
        <message>
            <source>not asked for</source>
            <translation>未请求</translation>
        </message>
        <message>
            <source>not changed by the kernel</source>
            <translation>内核不改变</translation>
        </message>
        <message>
            <source>not enough memory for so many layers and points</source>
            <translation>内存不足以容纳这么多层和点</translation>
        </message>
        <message>
            <source>not enough memory to slice %1</source>
            <translation>内存不足，无法切片 %1</translation>
        </message>
        <message>
            <source>not in a trace</source>
            <translation>轨迹中没有</translation>
        </message>
        <message>
            <source>not known</source>
            <translation>未知</translation>
        </message>
        <message>
            <source>not known: the surface is not closed, or turned both ways</source>
            <translation>未知：表面不封闭或朝向不一</translation>
        </message>
        <message>
            <source>not needed</source>
            <translation>不需要</translation>
        </message>
        <message>
            <source>not needed on the virtual clock</source>
            <translation>虚拟时钟下不需要</translation>
        </message>
        <message>
            <source>not published</source>
            <translation>未发布</translation>
        </message>
        <message>
            <source>not reached</source>
            <translation>未到达</translation>
        </message>
        <message>
            <source>not recorded</source>
            <translation>未记录</translation>
        </message>
        <message>
            <source>not sliced</source>
            <translation>未切片</translation>
        </message>
        <message>
            <source>not while %1; %2</source>
            <translation>当前状态（%1）下不可用；%2</translation>
        </message>
        <message>
            <source>nothing</source>
            <translation>无</translation>
        </message>
        <message>
            <source>nothing in the block uses %1</source>
            <translation>程序段中没有代码使用 %1</translation>
        </message>
        <message>
            <source>nothing is open</source>
            <translation>没有打开任何文件</translation>
        </message>
        <message>
            <source>nothing that can be read here: a mesh (STL, OBJ, PLY, 3MF, OFF), a drawing (SVG, DXF), a picture (PNG, JPEG, TIFF, BMP, PGM) or a table (CSV)</source>
            <translation>无法读取的文件：可读取网格（STL、OBJ、PLY、3MF、OFF）、图纸（SVG、DXF）、图片（PNG、JPEG、TIFF、BMP、PGM）或表格（CSV）</translation>
        </message>
        <message>
            <source>nothing was carved</source>
            <translation>没有雕刻任何部分</translation>
        </message>
        <message>
            <source>nothing was carved yet</source>
            <translation>尚未雕刻任何内容</translation>
        </message>
        <message>
            <source>o%1 is a subroutine in line %2</source>
            <translation>o%1 已是第 %2 行的子程序</translation>
        </message>
        <message>
            <source>o%1 sub is called by o%1 call</source>
            <translation>o%1 sub 须用 o%1 call 调用</translation>
        </message>
        <message>
            <source>of %1</source>
            <translation>共 %1</translation>
        </message>
        <message>
            <source>of an unknown text</source>
            <translation>文本未知</translation>
        </message>
        <message>
            <source>off</source>
            <translation>关闭</translation>
        </message>
        <message>
            <source>on hold; Resume goes on</source>
            <translation>暂停中；按“继续”接着运行</translation>
        </message>
        <message>
            <source>only --port io:ADDRESS can drive a machine</source>
            <translation>只能通过 --port io:ADDRESS 驱动机器</translation>
        </message>
        <message>
            <source>only in a trace</source>
            <translation>仅在轨迹中</translation>
        </message>
        <message>
            <source>only the simulated machine can be driven</source>
            <translation>只能驱动仿真机床</translation>
        </message>
        <message>
            <source>only with the drives off</source>
            <translation>仅在驱动关闭时可用</translation>
        </message>
        <message>
            <source>open a model</source>
            <translation>打开模型</translation>
        </message>
        <message>
            <source>open edges</source>
            <translation>开放边</translation>
        </message>
        <message>
            <source>open edges: %1</source>
            <translation>开放边：%1</translation>
        </message>
        <message>
            <source>opening was cancelled</source>
            <translation>已取消打开</translation>
        </message>
        <message>
            <source>optional stop (M1)</source>
            <translation>选择停止（M1）</translation>
        </message>
        <message>
            <source>optional-stop</source>
            <translation>选择停止</translation>
        </message>
        <message>
            <source>ordinary scheduling</source>
            <translation>普通调度</translation>
        </message>
        <message>
            <source>other</source>
            <translation>其他</translation>
        </message>
        <message>
            <source>other programs and interrupts run where the tick does</source>
            <translation>其他程序和中断与节拍在同一处理器上运行</translation>
        </message>
        <message>
            <source>out</source>
            <translation>出</translation>
        </message>
        <message>
            <source>outputs and inputs have numbers 0 to 63</source>
            <translation>输出和输入的编号为 0 至 63</translation>
        </message>
        <message>
            <source>over-ticks or within-tick</source>
            <translation>over-ticks 或 within-tick</translation>
        </message>
        <message>
            <source>override</source>
            <translation>倍率</translation>
        </message>
        <message>
            <source>override of rapids</source>
            <translation>快速倍率</translation>
        </message>
        <message>
            <source>own or follow</source>
            <translation>own 或 follow</translation>
        </message>
        <message>
            <source>parallel port</source>
            <translation>并口</translation>
        </message>
        <message>
            <source>pass 30 values at most</source>
            <translation>最多传递 30 个值</translation>
        </message>
        <message>
            <source>passed</source>
            <translation>通过</translation>
        </message>
        <message>
            <source>path or stepwise</source>
            <translation>path 或 stepwise</translation>
        </message>
        <message>
            <source>performance</source>
            <translation>性能模式</translation>
        </message>
        <message>
            <source>pins</source>
            <translation>引脚测试</translation>
        </message>
        <message>
            <source>plan starved</source>
            <translation>规划供不应求</translation>
        </message>
        <message>
            <source>point by point takes one or two of R1, R2 and Y</source>
            <translation>逐点移动需要 R1、R2 和 Y 中的一个或两个轴</translation>
        </message>
        <message>
            <source>point, ball, flat or vee</source>
            <translation>point、ball、flat 或 vee</translation>
        </message>
        <message>
            <source>points</source>
            <translation>点数</translation>
        </message>
        <message>
            <source>points do not follow each other from 0 on, as many in each layer</source>
            <translation>各点须从 0 起依次排列，且每层点数相同</translation>
        </message>
        <message>
            <source>port error</source>
            <translation>端口故障</translation>
        </message>
        <message>
            <source>positioning</source>
            <translation>定位中</translation>
        </message>
        <message>
            <source>priority up to %1</source>
            <translation>优先级最高 %1</translation>
        </message>
        <message>
            <source>priority up to %1 only, the tick has %2</source>
            <translation>优先级最高仅 %1，节拍需要 %2</translation>
        </message>
        <message>
            <source>processor %1</source>
            <translation>处理器 %1</translation>
        </message>
        <message>
            <source>processor of the tick</source>
            <translation>节拍的处理器</translation>
        </message>
        <message>
            <source>processor sleep</source>
            <translation>处理器休眠</translation>
        </message>
        <message>
            <source>processor speed</source>
            <translation>处理器频率</translation>
        </message>
        <message>
            <source>processor: as the core</source>
            <translation>处理器：同内核</translation>
        </message>
        <message>
            <source>processors kept awake</source>
            <translation>处理器保持唤醒</translation>
        </message>
        <message>
            <source>processors that sleep deeply wake up late</source>
            <translation>深度休眠的处理器醒得晚</translation>
        </message>
        <message>
            <source>profile</source>
            <translation>配置</translation>
        </message>
        <message>
            <source>profile %1</source>
            <translation>配置 %1</translation>
        </message>
        <message>
            <source>profile as the job's</source>
            <translation>配置同作业</translation>
        </message>
        <message>
            <source>profile unknown</source>
            <translation>配置未知</translation>
        </message>
        <message>
            <source>profile: %1</source>
            <translation>配置：%1</translation>
        </message>
        <message>
            <source>program</source>
            <translation>程序</translation>
        </message>
        <message>
            <source>program %1 is not the one that waits to be run; start it again</source>
            <translation>程序 %1 不是等待运行的那个程序；请重新启动程序</translation>
        </message>
        <message>
            <source>psi goes further in a layer than any machine</source>
            <translation>Ψ 在一层内的行程超出任何机床</translation>
        </message>
        <message>
            <source>psicarve gcode run FILE --from-line %1</source>
            <translation>psicarve gcode run FILE --from-line %1</translation>
        </message>
        <message>
            <source>psicarve-hmi --opengl tries it again</source>
            <translation>psicarve-hmi --opengl 可再次尝试</translation>
        </message>
        <message>
            <source>publish first</source>
            <translation>请先发布</translation>
        </message>
        <message>
            <source>publishing was cancelled</source>
            <translation>已取消发布</translation>
        </message>
        <message>
            <source>pul.</source>
            <translation>脉冲</translation>
        </message>
        <message>
            <source>pulses</source>
            <translation>脉冲</translation>
        </message>
        <message>
            <source>pulses and counts are whole numbers</source>
            <translation>脉冲和计数须为整数</translation>
        </message>
        <message>
            <source>put % on a line of its own, as the first and the last one</source>
            <translation>请让 % 单独成行，作为首行和末行</translation>
        </message>
        <message>
            <source>put it where docs/gcode.md allows it</source>
            <translation>请放在 docs/gcode.md 允许的位置</translation>
        </message>
        <message>
            <source>put one of the two into a block of its own</source>
            <translation>请把其中之一移到单独的程序段</translation>
        </message>
        <message>
            <source>put the units into a block before the feed</source>
            <translation>请在进给之前的程序段中设定单位</translation>
        </message>
        <message>
            <source>queue: %1 of %2</source>
            <translation>队列：%1 / %2</translation>
        </message>
        <message>
            <source>radii</source>
            <translation>半径</translation>
        </message>
        <message>
            <source>radii of R1: %1 points differ, the first in layer %2, point %3, counted from 0</source>
            <translation>R1 半径：%1 点不同，首个在第 %2 层第 %3 点（从 0 计）</translation>
        </message>
        <message>
            <source>radii of R2: %1 points differ, the first in layer %2, point %3, counted from 0</source>
            <translation>R2 半径：%1 点不同，首个在第 %2 层第 %3 点（从 0 计）</translation>
        </message>
        <message>
            <source>raise the limit: a line "@GROUP - memlock unlimited" in /etc/security/limits.d and a new login, or the capability CAP_IPC_LOCK</source>
            <translation>提高限额：在 /etc/security/limits.d 中加入一行 "@GROUP - memlock unlimited" 并重新登录，或授予 CAP_IPC_LOCK 能力</translation>
        </message>
        <message>
            <source>raw addresses</source>
            <translation>直接端口地址</translation>
        </message>
        <message>
            <source>reachable</source>
            <translation>可到达</translation>
        </message>
        <message>
            <source>reading it takes about a microsecond, several times a tick</source>
            <translation>读取一次约一微秒，每个节拍读取数次</translation>
        </message>
        <message>
            <source>ready</source>
            <translation>就绪</translation>
        </message>
        <message>
            <source>real clock</source>
            <translation>实时时钟</translation>
        </message>
        <message>
            <source>real-time scheduling</source>
            <translation>实时调度</translation>
        </message>
        <message>
            <source>record</source>
            <translation>记录</translation>
        </message>
        <message>
            <source>recorded</source>
            <translation>已记录</translation>
        </message>
        <message>
            <source>refused</source>
            <translation>被拒绝</translation>
        </message>
        <message>
            <source>replay --program FILE</source>
            <translation>replay --program FILE</translation>
        </message>
        <message>
            <source>report of the slicer</source>
            <translation>切片报告</translation>
        </message>
        <message>
            <source>reset first</source>
            <translation>请先复位</translation>
        </message>
        <message>
            <source>reset the alarm first</source>
            <translation>请先复位报警</translation>
        </message>
        <message>
            <source>reset-alarm</source>
            <translation>复位报警</translation>
        </message>
        <message>
            <source>reset-height</source>
            <translation>高度回零</translation>
        </message>
        <message>
            <source>resume</source>
            <translation>继续</translation>
        </message>
        <message>
            <source>resume, or stop</source>
            <translation>请继续或停止</translation>
        </message>
        <message>
            <source>return outside a subroutine</source>
            <translation>return 不在子程序之内</translation>
        </message>
        <message>
            <source>right</source>
            <translation>右</translation>
        </message>
        <message>
            <source>rmmod lp, and keep it out: a line "blacklist lp" in /etc/modprobe.d</source>
            <translation>rmmod lp，并在 /etc/modprobe.d 中写 "blacklist lp" 以防再次加载</translation>
        </message>
        <message>
            <source>roughing %1 of %2</source>
            <translation>粗加工第 %1 遍，共 %2 遍</translation>
        </message>
        <message>
            <source>roughing begins at the blank's surface: say how large the blank is, or choose finishing only</source>
            <translation>粗加工从毛坯表面开始：请给出毛坯尺寸，或选择“只做精加工”</translation>
        </message>
        <message>
            <source>roughing needs level layers, which a table of a spiral does not have: slice the model with roughing, or choose finishing only</source>
            <translation>粗加工需要水平的层，而螺旋的表格没有：请连同粗加工重新切片模型，或选择“只做精加工”</translation>
        </message>
        <message>
            <source>run with CAP_SYS_RAWIO, or use --port ppdev:/dev/parport0</source>
            <translation>请以 CAP_SYS_RAWIO 权限运行，或使用 --port ppdev:/dev/parport0</translation>
        </message>
        <message>
            <source>runs and passes do not count on by one</source>
            <translation>run 和 pass 没有逐一递增</translation>
        </message>
        <message>
            <source>say with P how near corners are passed</source>
            <translation>请用 P 指定通过拐角的接近程度</translation>
        </message>
        <message>
            <source>say with an axis word what is to be done</source>
            <translation>请用轴字说明要做什么</translation>
        </message>
        <message>
            <source>says nothing here</source>
            <translation>此处不适用</translation>
        </message>
        <message>
            <source>see in the kernel's messages why the tsc is not trusted; often the firmware is to blame</source>
            <translation>查看内核消息，了解为何不信任 tsc；常为固件原因</translation>
        </message>
        <message>
            <source>segment %1</source>
            <translation>共享段 %1</translation>
        </message>
        <message>
            <source>segment lost</source>
            <translation>共享段丢失</translation>
        </message>
        <message>
            <source>set R above the depth of the hole</source>
            <translation>请把 R 设在孔底之上</translation>
        </message>
        <message>
            <source>set the centre off the arc</source>
            <translation>圆心不要落在圆弧端点上</translation>
        </message>
        <message>
            <source>set the parameter before it is used</source>
            <translation>请在使用前设置参数</translation>
        </message>
        <message>
            <source>set the speed at the spindle</source>
            <translation>请在主轴上设定转速</translation>
        </message>
        <message>
            <source>shared memory</source>
            <translation>共享内存</translation>
        </message>
        <message>
            <source>shortest or written</source>
            <translation>shortest 或 written</translation>
        </message>
        <message>
            <source>shutdown</source>
            <translation>关闭内核</translation>
        </message>
        <message>
            <source>silent</source>
            <translation>无响应</translation>
        </message>
        <message>
            <source>single</source>
            <translation>单段</translation>
        </message>
        <message>
            <source>single block</source>
            <translation>单段</translation>
        </message>
        <message>
            <source>single block: this one is done; Resume runs the next</source>
            <translation>单段：本段已完成；按“继续”运行下一段</translation>
        </message>
        <message>
            <source>single or two-timer</source>
            <translation>single 或 two-timer</translation>
        </message>
        <message>
            <source>slice first</source>
            <translation>请先切片</translation>
        </message>
        <message>
            <source>slicing was cancelled</source>
            <translation>已取消切片</translation>
        </message>
        <message>
            <source>something stands behind the O word</source>
            <translation>O 字之后还有内容</translation>
        </message>
        <message>
            <source>spindle</source>
            <translation>主轴</translation>
        </message>
        <message>
            <source>spiral</source>
            <translation>螺旋</translation>
        </message>
        <message>
            <source>split the block: a line has 1024 bytes at most</source>
            <translation>请拆分程序段：一行最多 1024 字节</translation>
        </message>
        <message>
            <source>stands %1 mm above the table, and the blank is only %2 mm high: nothing of it is left to be carved</source>
            <translation>距工作台 %1 mm，而毛坯仅高 %2 mm：没有可加工的部分</translation>
        </message>
        <message>
            <source>start</source>
            <translation>启动</translation>
        </message>
        <message>
            <source>start first</source>
            <translation>请先启动</translation>
        </message>
        <message>
            <source>start the core with --clock virtual, or raise tick.missed_alarm_per_s</source>
            <translation>用 --clock virtual 启动内核，或提高 tick.missed_alarm_per_s</translation>
        </message>
        <message>
            <source>start the kernel with isolcpus=N nohz_full=N rcu_nocbs=N, N the last processor</source>
            <translation>用 isolcpus=N nohz_full=N rcu_nocbs=N 启动内核，N 为最后一个处理器</translation>
        </message>
        <message>
            <source>start the kernel with processor.max_cstate=1, or one that has that device</source>
            <translation>用 processor.max_cstate=1 启动内核，或使用带该设备的内核</translation>
        </message>
        <message>
            <source>start, or stop</source>
            <translation>请启动或停止</translation>
        </message>
        <message>
            <source>start-interpolation</source>
            <translation>开始雕刻</translation>
        </message>
        <message>
            <source>status</source>
            <translation>状态</translation>
        </message>
        <message>
            <source>status: %1</source>
            <translation>状态：%1</translation>
        </message>
        <message>
            <source>step by step</source>
            <translation>逐步</translation>
        </message>
        <message>
            <source>steps lost</source>
            <translation>丢步</translation>
        </message>
        <message>
            <source>still tripped: %1; release it or back off</source>
            <translation>仍处于触发状态：%1；请松开或退离开关</translation>
        </message>
        <message>
            <source>stop (M0)</source>
            <translation>停止（M0）</translation>
        </message>
        <message>
            <source>stopped</source>
            <translation>已停止</translation>
        </message>
        <message>
            <source>stopped %1</source>
            <translation>停止于 %1</translation>
        </message>
        <message>
            <source>stopped by the operator</source>
            <translation>被操作员停止</translation>
        </message>
        <message>
            <source>stopped in layer %1</source>
            <translation>停在第 %1 层</translation>
        </message>
        <message>
            <source>stopping</source>
            <translation>停止中</translation>
        </message>
        <message>
            <source>store the program in a file: there it may be of any length</source>
            <translation>请把程序存为文件：文件长度不限</translation>
        </message>
        <message>
            <source>straight line</source>
            <translation>直线</translation>
        </message>
        <message>
            <source>supervisor stalled</source>
            <translation>内核听不到命令</translation>
        </message>
        <message>
            <source>swap</source>
            <translation>交换区</translation>
        </message>
        <message>
            <source>swapoff --all while carving, or more memory</source>
            <translation>雕刻时执行 swapoff --all，或增加内存</translation>
        </message>
        <message>
            <source>switch coolant by hand</source>
            <translation>请手动开关冷却液</translation>
        </message>
        <message>
            <source>systems have numbers 0 to 9</source>
            <translation>坐标系编号为 0 至 9</translation>
        </message>
        <message>
            <source>take it out: nothing is wired there</source>
            <translation>请删除：那里没有接线</translation>
        </message>
        <message>
            <source>take it out: the operator's overrides always hold</source>
            <translation>请删除：操作员的倍率始终有效</translation>
        </message>
        <message>
            <source>take the inner ( away</source>
            <translation>请去掉里面的 (</translation>
        </message>
        <message>
            <source>take the word away, or add the code that it is for</source>
            <translation>请去掉该字，或补上它所属的代码</translation>
        </message>
        <message>
            <source>taken up to line %1</source>
            <translation>已取到第 %1 行</translation>
        </message>
        <message>
            <source>takes %1, with those before %2</source>
            <translation>需 %1，连同之前各层 %2</translation>
        </message>
        <message>
            <source>takes about %1, with those before %2</source>
            <translation>约需 %1，连同之前的层 %2</translation>
        </message>
        <message>
            <source>takes at least %1, with those before %2</source>
            <translation>至少需 %1，连同之前各层 %2</translation>
        </message>
        <message>
            <source>testing</source>
            <translation>测试中</translation>
        </message>
        <message>
            <source>that is a record of the other kind of machine; this core keeps none</source>
            <translation>这是另一种机床的记录；此内核不保存</translation>
        </message>
        <message>
            <source>the XML ends too early</source>
            <translation>XML 过早结束</translation>
        </message>
        <message>
            <source>the allowance must be 0 to %1, not %2</source>
            <translation>余量必须为 0 到 %1，而不是 %2</translation>
        </message>
        <message>
            <source>the arc ends where it begins</source>
            <translation>圆弧的终点就是起点</translation>
        </message>
        <message>
            <source>the arc has a centre and a radius</source>
            <translation>圆弧同时有圆心和半径</translation>
        </message>
        <message>
            <source>the arc has no centre and no radius</source>
            <translation>圆弧既没有圆心也没有半径</translation>
        </message>
        <message>
            <source>the arc's centre lies on one of its ends</source>
            <translation>圆弧的圆心位于其一端</translation>
        </message>
        <message>
            <source>the arc's radius is %1 mm at its begin and %2 mm at its end</source>
            <translation>圆弧起点处半径 %1 mm，终点处 %2 mm</translation>
        </message>
        <message>
            <source>the archive unpacks to far more than a model needs</source>
            <translation>压缩包解开后远大于模型所需</translation>
        </message>
        <message>
            <source>the axis has no sensor</source>
            <translation>此轴没有传感器</translation>
        </message>
        <message>
            <source>the axis passes beside the model and no sample meets it: nothing but the core would be carved; choose another axis</source>
            <translation>轴线在模型之外，没有采样点碰到模型：只会加工出芯轴；请另选轴线</translation>
        </message>
        <message>
            <source>the blank reaches out to %1, but head %2 only to %3: it would stand in the blank before the carving begins; take a smaller blank</source>
            <translation>毛坯伸到 %1，而刀头 %2 只能到 %3：雕刻开始前刀头就会处在毛坯里；请用较小的毛坯</translation>
        </message>
        <message>
            <source>the built-in profile has no file: save it under a name</source>
            <translation>内置配置没有文件：请另存为一个文件</translation>
        </message>
        <message>
            <source>the centre: no axis goes so far (%1)</source>
            <translation>圆心：没有轴能走这么远（%1）</translation>
        </message>
        <message>
            <source>the comment has no end</source>
            <translation>注释没有结尾</translation>
        </message>
        <message>
            <source>the computer has too little free memory: end other programs</source>
            <translation>本机空闲内存太少：请结束其他程序</translation>
        </message>
        <message>
            <source>the core cannot drive it</source>
            <translation>内核无法驱动它</translation>
        </message>
        <message>
            <source>the core cannot record so, or knows nobody to record for</source>
            <translation>内核不能这样记录，或不知道为谁记录</translation>
        </message>
        <message>
            <source>the core did not answer within %1 ms</source>
            <translation>内核在 %1 ms 内没有回答</translation>
        </message>
        <message>
            <source>the core did not judge the job within %1 ms</source>
            <translation>内核未在 %1 ms 内检查完作业</translation>
        </message>
        <message>
            <source>the core did not take the program's next step in time</source>
            <translation>内核未能及时接收程序的下一步</translation>
        </message>
        <message>
            <source>the core does not know this command; is it another version?</source>
            <translation>内核不认识此命令；是否版本不同？</translation>
        </message>
        <message>
            <source>the core ended before it answered</source>
            <translation>内核在回答之前已结束</translation>
        </message>
        <message>
            <source>the core has another profile than %1; open the one that it was started with</source>
            <translation>内核的配置不是 %1；请打开启动内核时所用的配置</translation>
        </message>
        <message>
            <source>the core has refused the next line: only Stop is left</source>
            <translation>内核拒绝了下一行：只能停止</translation>
        </message>
        <message>
            <source>the core of segment %1 (process %2) is silent</source>
            <translation>共享段 %1 的内核（进程 %2）没有响应</translation>
        </message>
        <message>
            <source>the core refuses it and gives no reason</source>
            <translation>内核拒绝此命令，且未说明原因</translation>
        </message>
        <message>
            <source>the core runs with another profile than %1; start it with that one</source>
            <translation>内核使用的配置不是 %1；请用它启动内核</translation>
        </message>
        <message>
            <source>the core takes no more of this program; start it again</source>
            <translation>内核不再接收此程序；请重新启动程序</translation>
        </message>
        <message>
            <source>the core was replaced before it did this</source>
            <translation>内核在执行之前已被替换</translation>
        </message>
        <message>
            <source>the core's disk has another record of this piece; look again</source>
            <translation>内核的磁盘上有此工件的另一条记录；请再看一次</translation>
        </message>
        <message>
            <source>the core's memory is locked, but a computer that swaps is late with everything else</source>
            <translation>内核进程的内存已锁定，但使用交换区的计算机其他一切都会迟到</translation>
        </message>
        <message>
            <source>the diameter of the blank is needed</source>
            <translation>需要毛坯直径</translation>
        </message>
        <message>
            <source>the diameter of the pin is needed</source>
            <translation>需要销的直径</translation>
        </message>
        <message>
            <source>the disk does not answer, and too much waits for it</source>
            <translation>磁盘没有响应，等待它的任务过多</translation>
        </message>
        <message>
            <source>the drawing is %1 mm high, and the cylinder only %2 mm: choose a larger height or a smaller scale</source>
            <translation>图形高 %1 mm，而圆柱只有 %2 mm：请加大高度或减小比例</translation>
        </message>
        <message>
            <source>the drawing is %1 mm wide, and once round the cylinder are only %2 mm: choose a scale of at most %3, a larger diameter, or all round</source>
            <translation>图形宽 %1 mm，而圆柱一周只有 %2 mm：比例最多选 %3，或加大直径，或选整周</translation>
        </message>
        <message>
            <source>the drawing would be more than ten metres wide or high</source>
            <translation>图形的宽或高将超过十米</translation>
        </message>
        <message>
            <source>the drawing's width or height is not more than 0</source>
            <translation>图形的宽或高不大于 0</translation>
        </message>
        <message>
            <source>the face names a vertex that is not there</source>
            <translation>该面引用了不存在的顶点</translation>
        </message>
        <message>
            <source>the file ends in the middle of a facet</source>
            <translation>文件在一个三角面中间结束</translation>
        </message>
        <message>
            <source>the file ends too early: there is no EOF</source>
            <translation>文件过早结束：没有 EOF</translation>
        </message>
        <message>
            <source>the file is empty</source>
            <translation>文件为空</translation>
        </message>
        <message>
            <source>the finishing pass is missing: the last run is of a roughing pass, and leaves what the model does not have</source>
            <translation>缺少精加工：最后一段属于粗加工，会留下模型上没有的材料</translation>
        </message>
        <message>
            <source>the first element is not &lt;svg&gt;</source>
            <translation>第一个元素不是 &lt;svg&gt;</translation>
        </message>
        <message>
            <source>the guard process ended; start the core again</source>
            <translation>看护进程已结束；请重新启动内核</translation>
        </message>
        <message>
            <source>the job from its begin</source>
            <translation>从开头起的作业</translation>
        </message>
        <message>
            <source>the job has no such layer</source>
            <translation>作业没有这一层</translation>
        </message>
        <message>
            <source>the job has not so many layers, but %1</source>
            <translation>作业没有这么多层，只有 %1 层</translation>
        </message>
        <message>
            <source>the job is carved to its end</source>
            <translation>作业已雕刻到最后</translation>
        </message>
        <message>
            <source>the job is published, but no core serves segment %1</source>
            <translation>作业已发布，但没有内核服务于共享段 %1</translation>
        </message>
        <message>
            <source>the job is unsound: %1</source>
            <translation>作业有误：%1</translation>
        </message>
        <message>
            <source>the job that it carries is damaged</source>
            <translation>其中所带的作业已损坏</translation>
        </message>
        <message>
            <source>the job was made for another machine (%1 differ); slice it again with the machine's profile</source>
            <translation>作业是为另一台机床生成的（%1 不同）；请用本机配置重新切片</translation>
        </message>
        <message>
            <source>the job's</source>
            <translation>作业自带</translation>
        </message>
        <message>
            <source>the job's blank has a height of %1, the profile's %2, which is in the heads' way</source>
            <translation>作业的毛坯高度为 %1，配置中为 %2，会挡住刀头</translation>
        </message>
        <message>
            <source>the job's blank has a height of %1, the profile's %2: a part of the job is air</source>
            <translation>作业的毛坯高度为 %1，配置中为 %2：作业的一部分是空切</translation>
        </message>
        <message>
            <source>the job's blank has a radius of %1, the profile's %2, which is in the heads' way</source>
            <translation>作业的毛坯半径为 %1，配置中为 %2，会挡住刀头</translation>
        </message>
        <message>
            <source>the job's blank has a radius of %1, the profile's %2: a part of the job is air</source>
            <translation>作业的毛坯半径为 %1，配置中为 %2：作业的一部分是空切</translation>
        </message>
        <message>
            <source>the job's blank stands %1 beside the profile's, which is in the heads' way</source>
            <translation>作业的毛坯与配置中的毛坯错开 %1，后者会挡住刀头</translation>
        </message>
        <message>
            <source>the job's blank stands %1 beside the profile's: a part of the job is air</source>
            <translation>作业的毛坯与配置中的毛坯错开 %1：作业的一部分是空切</translation>
        </message>
        <message>
            <source>the job's direction of axis %1 is the other way round on this machine; slice the model for this machine's profile</source>
            <translation>作业中 %1 轴的方向与本机床相反；请按本机床的配置切片</translation>
        </message>
        <message>
            <source>the kernel has one, but /dev/parport0 is not there</source>
            <translation>内核有并口，但没有 /dev/parport0</translation>
        </message>
        <message>
            <source>the kernel itself keeps the tick waiting, at times for milliseconds; they are skipped and counted</source>
            <translation>内核本身会让节拍等待，有时达数毫秒；这些节拍被跳过并计数</translation>
        </message>
        <message>
            <source>the largest job takes %1</source>
            <translation>最大的作业需要 %1</translation>
        </message>
        <message>
            <source>the largest job takes %1, two may be there</source>
            <translation>最大的作业需要 %1，可能同时有两个</translation>
        </message>
        <message>
            <source>the last row does not close the spiral</source>
            <translation>最后一行没有使螺旋闭合</translation>
        </message>
        <message>
            <source>the line has more than 1024 bytes</source>
            <translation>该行超过 1024 字节</translation>
        </message>
        <message>
            <source>the machine came to rest (%1), somebody stopped it</source>
            <translation>机床已停下（%1），有人停止了它</translation>
        </message>
        <message>
            <source>the machine has moved since the program was read; start it again</source>
            <translation>读取程序之后机床移动过；请重新启动程序</translation>
        </message>
        <message>
            <source>the machine has no axis %1</source>
            <translation>机床没有 %1 轴</translation>
        </message>
        <message>
            <source>the machine has no output for coolant</source>
            <translation>机床没有冷却液输出</translation>
        </message>
        <message>
            <source>the machine has no output for flood</source>
            <translation>机床没有冷却液输出</translation>
        </message>
        <message>
            <source>the machine has no output for mist</source>
            <translation>机床没有喷雾输出</translation>
        </message>
        <message>
            <source>the machine has not come to rest yet (%1)</source>
            <translation>机床尚未停下（%1）</translation>
        </message>
        <message>
            <source>the machine is %1; home it, jog %2 to the pin, and let it rest</source>
            <translation>机床状态：%1；请回零，将 %2 点动到销处并停稳</translation>
        </message>
        <message>
            <source>the machine is busy; try again</source>
            <translation>机床正忙；请重试</translation>
        </message>
        <message>
            <source>the machine is not at rest; stop first</source>
            <translation>机床未静止；请先停止</translation>
        </message>
        <message>
            <source>the machine is not homed; home first</source>
            <translation>机床未回零；请先回零</translation>
        </message>
        <message>
            <source>the machine was moved or its spindle switched meanwhile; nothing was begun, start it again</source>
            <translation>其间机床被移动过或主轴被开关过；没有开始，请重新启动</translation>
        </message>
        <message>
            <source>the mesh has no volume (all of it is flat); there is nothing to carve</source>
            <translation>网格没有体积（全部是平的）；没有可雕刻的内容</translation>
        </message>
        <message>
            <source>the number of an O word is whole</source>
            <translation>O 字的编号是整数</translation>
        </message>
        <message>
            <source>the port does not answer: switch the machine off by its own switch</source>
            <translation>端口没有应答：用机床自身的开关关断机床</translation>
        </message>
        <message>
            <source>the port has failed; reset the alarm, then home</source>
            <translation>端口发生过故障；复位报警，然后回零</translation>
        </message>
        <message>
            <source>the printer driver may take the port</source>
            <translation>打印机驱动可能占用端口</translation>
        </message>
        <message>
            <source>the process that feeds it is gone: only Stop is left</source>
            <translation>供给它的进程已消失：只能停止</translation>
        </message>
        <message>
            <source>the profile is %1 bytes long; the most is %2</source>
            <translation>配置长 %1 字节；最多 %2 字节</translation>
        </message>
        <message>
            <source>the program breaks off behind line %1: who read it is gone; start it again</source>
            <translation>程序在第 %1 行之后中断：读取程序的进程已不在；请重新启动程序</translation>
        </message>
        <message>
            <source>the program does not reach the core as it was read; start it again</source>
            <translation>程序没有原样到达内核；请重新启动程序</translation>
        </message>
        <message>
            <source>the program ends before line %1; begin at an earlier line</source>
            <translation>程序在第 %1 行之前结束；请从更前面的行开始</translation>
        </message>
        <message>
            <source>the program has no end</source>
            <translation>程序没有结尾</translation>
        </message>
        <message>
            <source>the program has no subroutine %1</source>
            <translation>程序中没有子程序 %1</translation>
        </message>
        <message>
            <source>the program is empty</source>
            <translation>程序是空的</translation>
        </message>
        <message>
            <source>the program was given up</source>
            <translation>程序已放弃</translation>
        </message>
        <message>
            <source>the published job is damaged; publish it again</source>
            <translation>已发布的作业已损坏；请重新发布</translation>
        </message>
        <message>
            <source>the pulses of a dry run</source>
            <translation>空运行的脉冲</translation>
        </message>
        <message>
            <source>the same job</source>
            <translation>同一作业</translation>
        </message>
        <message>
            <source>the speed must be above 0</source>
            <translation>速度必须大于 0</translation>
        </message>
        <message>
            <source>the spindle is on; for a dry run switch it off</source>
            <translation>主轴开着；空运行请先关闭主轴</translation>
        </message>
        <message>
            <source>the stepdown must be more than 0 mm, and %1 at most, not %2</source>
            <translation>下切步距必须大于 0 mm 且不超过 %1，而不是 %2</translation>
        </message>
        <message>
            <source>the stepover must be more than 0 mm, not %1</source>
            <translation>层距必须大于 0 mm，而不是 %1</translation>
        </message>
        <message>
            <source>the stream ends within a line: it may have been torn off, and is not run</source>
            <translation>数据流在行中结束：可能已中断，该行不运行</translation>
        </message>
        <message>
            <source>the subroutine that M98 calls has no M99</source>
            <translation>M98 调用的子程序没有 M99</translation>
        </message>
        <message>
            <source>the switch of the axis is open; there is nothing to back off from</source>
            <translation>此轴的开关未闭合；无需退离</translation>
        </message>
        <message>
            <source>the table has no layers</source>
            <translation>表格没有层</translation>
        </message>
        <message>
            <source>the table has roughing passes of its own: it gets no others</source>
            <translation>表格自带粗加工各道：不再添加</translation>
        </message>
        <message>
            <source>the table's %1 points a circle are evened to %2</source>
            <translation>表格每圈 %1 个点已均衡为 %2 个</translation>
        </message>
        <message>
            <source>the table's axis would be outside a blank of radius %1 mm; set blank.radius_mm, or a lesser offset</source>
            <translation>转台轴线将在半径 %1 mm 的毛坯之外；请设 blank.radius_mm，或减小偏移</translation>
        </message>
        <message>
            <source>the table's last layer is not whole, or there is none</source>
            <translation>表格最后一层不完整，或没有层</translation>
        </message>
        <message>
            <source>the tip of %1 would stand %2 mm further out than counted; is the pin's diameter %3 mm, and does the tip touch it at %4 mm?</source>
            <translation>%1 的刀尖会比计数位置靠外 %2 mm；销的直径是 %3 mm 吗？刀尖在 %4 mm 处接触吗？</translation>
        </message>
        <message>
            <source>the tips of r1 and r2 are %1 mm apart, closer than head_clearance_mm = %2 mm</source>
            <translation>r1 和 r2 的刀尖相距 %1 mm，小于 head_clearance_mm = %2 mm</translation>
        </message>
        <message>
            <source>the travel from %1 to %2 mm is empty or reversed; give the lowest position first</source>
            <translation>行程 %1 到 %2 mm 为空或颠倒；请先写最低位置</translation>
        </message>
        <message>
            <source>the value is infinite, or none at all</source>
            <translation>值为无穷大或不存在</translation>
        </message>
        <message>
            <source>the whole job</source>
            <translation>整个作业</translation>
        </message>
        <message>
            <source>the work offsets have been changed since it was read; decode it again</source>
            <translation>读取之后工件偏置已更改；请重新解析</translation>
        </message>
        <message>
            <source>the zip archive is cut off or damaged</source>
            <translation>zip 压缩包被截断或已损坏</translation>
        </message>
        <message>
            <source>then about Y</source>
            <translation>再绕 Y</translation>
        </message>
        <message>
            <source>then about Z</source>
            <translation>再绕 Z</translation>
        </message>
        <message>
            <source>there</source>
            <translation>有</translation>
        </message>
        <message>
            <source>there is no &lt;svg&gt; element</source>
            <translation>没有 &lt;svg&gt; 元素</translation>
        </message>
        <message>
            <source>there is no alarm</source>
            <translation>没有报警</translation>
        </message>
        <message>
            <source>these are no two numbers; enter them as 0.0 ... 60.0</source>
            <translation>这不是两个数字；请按 0.0 ... 60.0 的形式输入</translation>
        </message>
        <message>
            <source>these work offsets cannot be kept</source>
            <translation>无法保存这些工件偏置</translation>
        </message>
        <message>
            <source>this is no DXF file: it does not begin with a section</source>
            <translation>这不是 DXF 文件：开头不是节</translation>
        </message>
        <message>
            <source>this is no number; enter %1 &lt;= value &lt;= %2</source>
            <translation>这不是数字；请输入 %1 到 %2</translation>
        </message>
        <message>
            <source>this is no whole number; enter %1 &lt;= value &lt;= %2</source>
            <translation>这不是整数；请输入 %1 到 %2</translation>
        </message>
        <message>
            <source>this is no word that can follow O</source>
            <translation>O 后不能用这个词</translation>
        </message>
        <message>
            <source>this is not TOML: %1; correct the line</source>
            <translation>这不是 TOML：%1；请改正该行</translation>
        </message>
        <message>
            <source>this is not well-formed XML</source>
            <translation>XML 格式不正确</translation>
        </message>
        <message>
            <source>this kernel lets nobody at addresses</source>
            <translation>此内核不允许任何程序访问端口地址</translation>
        </message>
        <message>
            <source>this kernel lets nobody at addresses: it is locked down (Secure Boot), or this is a container</source>
            <translation>此内核不允许任何程序访问端口地址：内核已锁定（Secure Boot），或这是容器</translation>
        </message>
        <message>
            <source>this kernel lets nobody at addresses: it is locked down (Secure Boot), or this is a container; --port ppdev:/dev/parport0 needs no such right</source>
            <translation>此内核不允许任何程序访问端口地址：内核已锁定（Secure Boot），或这是容器；--port ppdev:/dev/parport0 不需要此权限</translation>
        </message>
        <message>
            <source>this kernel lets nobody at addresses; --port ppdev:/dev/parport0 needs no such right</source>
            <translation>此内核不允许任何程序访问端口地址；--port ppdev:/dev/parport0 不需要此权限</translation>
        </message>
        <message>
            <source>tick %1 µs</source>
            <translation>节拍 %1 µs</translation>
        </message>
        <message>
            <source>tick gap</source>
            <translation>节拍中断</translation>
        </message>
        <message>
            <source>time from point to point</source>
            <translation>点间用时</translation>
        </message>
        <message>
            <source>time not known</source>
            <translation>时间未知</translation>
        </message>
        <message>
            <source>to look at</source>
            <translation>留意</translation>
        </message>
        <message>
            <source>too deep %1 material left&lt;br&gt;±%2 mm, ±%3 pulses</source>
            <translation>过深 %1 有余料&lt;br&gt;±%2 mm，±%3 脉冲</translation>
        </message>
        <message>
            <source>too large for this computer's memory</source>
            <translation>超出本机内存</translation>
        </message>
        <message>
            <source>too many commands at once; wait for the others</source>
            <translation>同时命令过多；请等待其他命令</translation>
        </message>
        <message>
            <source>tool change (M6)</source>
            <translation>换刀（M6）</translation>
        </message>
        <message>
            <source>true or false</source>
            <translation>true 或 false</translation>
        </message>
        <message>
            <source>turn of the table in a layer [pulses]</source>
            <translation>每层转台转动 [脉冲]</translation>
        </message>
        <message>
            <source>turn the axis in a block before the cycle</source>
            <translation>请在固定循环之前的程序段中转动该轴</translation>
        </message>
        <message>
            <source>turned by %1°</source>
            <translation>旋转 %1°</translation>
        </message>
        <message>
            <source>two codes of the block use P</source>
            <translation>程序段中有两个代码使用 P</translation>
        </message>
        <message>
            <source>two programs on one port move motors by accident</source>
            <translation>两个程序用同一端口会意外驱动电机</translation>
        </message>
        <message>
            <source>under G90.1 an arc has both %1 and %2</source>
            <translation>G90.1 下圆弧须同时有 %1 和 %2</translation>
        </message>
        <message>
            <source>under way</source>
            <translation>进行中</translation>
        </message>
        <message>
            <source>undercut %1 %</source>
            <translation>倒扣 %1 %</translation>
        </message>
        <message>
            <source>undercut about %1 %</source>
            <translation>倒扣约 %1 %</translation>
        </message>
        <message>
            <source>unknown</source>
            <translation>未知</translation>
        </message>
        <message>
            <source>unknown key; did you mean %1?</source>
            <translation>未知的键；是否指 %1？</translation>
        </message>
        <message>
            <source>unknown key; see profile show for all keys</source>
            <translation>未知的键；全部键见 profile show</translation>
        </message>
        <message>
            <source>unlimited</source>
            <translation>无限制</translation>
        </message>
        <message>
            <source>use --port ppdev:/dev/parport0</source>
            <translation>请使用 --port ppdev:/dev/parport0</translation>
        </message>
        <message>
            <source>use G17, or take the rotation away with G10 L2 R0</source>
            <translation>请使用 G17，或用 G10 L2 R0 取消旋转</translation>
        </message>
        <message>
            <source>use G53 in a block with G0 or G1</source>
            <translation>请在含 G0 或 G1 的程序段中使用 G53</translation>
        </message>
        <message>
            <source>use G53 under G90</source>
            <translation>请在 G90 下使用 G53</translation>
        </message>
        <message>
            <source>use G94 for cycles</source>
            <translation>固定循环请使用 G94</translation>
        </message>
        <message>
            <source>use M3: the spindle is only switched</source>
            <translation>请使用 M3：主轴只能开关</translation>
        </message>
        <message>
            <source>use an O word as docs/gcode.md has them</source>
            <translation>O 字请按 docs/gcode.md 使用</translation>
        </message>
        <message>
            <source>use fewer levels: 64 of brackets, 100 of O words, 100 of calls</source>
            <translation>请减少层数：括号 64，O 字 100，调用 100</translation>
        </message>
        <message>
            <source>use fewer names</source>
            <translation>请少用一些名称</translation>
        </message>
        <message>
            <source>use one of the G codes of docs/gcode.md</source>
            <translation>请使用 docs/gcode.md 中的 G 代码</translation>
        </message>
        <message>
            <source>use one of the M codes of docs/gcode.md</source>
            <translation>请使用 docs/gcode.md 中的 M 代码</translation>
        </message>
        <message>
            <source>use the GNU C library's allocator</source>
            <translation>使用 GNU C 库的内存分配器</translation>
        </message>
        <message>
            <source>use the letters that [gcode] in the profile gives to the axes</source>
            <translation>请使用配置中 [gcode] 给各轴的字母</translation>
        </message>
        <message>
            <source>use the operators and functions of docs/gcode.md</source>
            <translation>请使用 docs/gcode.md 中的运算符和函数</translation>
        </message>
        <message>
            <source>use the parameters #1 to #5601</source>
            <translation>请使用参数 #1 至 #5601</translation>
        </message>
        <message>
            <source>virtual clock</source>
            <translation>虚拟时钟</translation>
        </message>
        <message>
            <source>wait, or stop</source>
            <translation>请等待或停止</translation>
        </message>
        <message>
            <source>waited for its lines: %1</source>
            <translation>等待程序行的次数：%1</translation>
        </message>
        <message>
            <source>waiting</source>
            <translation>等待中</translation>
        </message>
        <message>
            <source>waits for more of it</source>
            <translation>等待后续内容</translation>
        </message>
        <message>
            <source>warning</source>
            <translation>警告</translation>
        </message>
        <message>
            <source>was written by another build of psicarve</source>
            <translation>由另一个版本的 psicarve 写成</translation>
        </message>
        <message>
            <source>what bounds the speed</source>
            <translation>限制速度的因素</translation>
        </message>
        <message>
            <source>what lies beyond the edge of &lt;%1&gt; is carved, too.</source>
            <translation>&lt;%1&gt; 边界以外的内容也会被加工。</translation>
        </message>
        <message>
            <source>where %1 stands is needed</source>
            <translation>需要 %1 的位置</translation>
        </message>
        <message>
            <source>where it was recorded</source>
            <translation>记录的末尾</translation>
        </message>
        <message>
            <source>whole</source>
            <translation>完整</translation>
        </message>
        <message>
            <source>without area: %1</source>
            <translation>无面积：%1</translation>
        </message>
        <message>
            <source>write #number=value or #&lt;name&gt;=value</source>
            <translation>请写成 #编号=值 或 #&lt;名称&gt;=值</translation>
        </message>
        <message>
            <source>write a number behind the letter</source>
            <translation>请在字母后写数字</translation>
        </message>
        <message>
            <source>write a whole number</source>
            <translation>请写整数</translation>
        </message>
        <message>
            <source>write it with fewer digits</source>
            <translation>请用更少的位数</translation>
        </message>
        <message>
            <source>write the subroutine into the same file</source>
            <translation>请把子程序写在同一文件中</translation>
        </message>
        <message>
            <source>yes</source>
            <translation>是</translation>
        </message>
        <message>
            <source>zigzag</source>
            <translation>往复</translation>
        </message>
        <message>
            <source>× NO CORE</source>
            <translation>× 无内核</translation>
        </message>
        <message>
            <source>Ψ / °, Y upwards / mm</source>
            <translation>Ψ / °，Y 向上 / mm</translation>
        </message>
        <message>
            <source>Ψ and Y after R1 and R2, or with them; home R1 and R2 first</source>
            <translation>Ψ 和 Y 须在 R1 和 R2 之后或同时回零；请先让 R1 和 R2 回零</translation>
        </message>
        <message>
            <source>Ψ axis</source>
            <translation>Ψ 轴</translation>
        </message>
        <message>
            <source>Ψ direction</source>
            <translation>Ψ 方向</translation>
        </message>
        <message>
            <source>Ψ enable</source>
            <translation>Ψ 使能</translation>
        </message>
        <message>
            <source>Ψ index</source>
            <translation>Ψ 零位</translation>
        </message>
        <message>
            <source>Ψ index: away</source>
            <translation>Ψ 零位：不在</translation>
        </message>
        <message>
            <source>Ψ index: not known</source>
            <translation>Ψ 零位：未知</translation>
        </message>
        <message>
            <source>Ψ index: there</source>
            <translation>Ψ 零位：在</translation>
        </message>
        <message>
            <source>Ψ step</source>
            <translation>Ψ 步进</translation>
        </message>
        <message>
            <source>Ψ turns to %1°, all turns.</source>
            <translation>Ψ 转到 %1°，含全部圈数。</translation>
        </message>
        <message>
            <source>Ψ turns.</source>
            <translation>Ψ 转动。</translation>
        </message>
        <message>
            <source>← →  Ψ
↑ ↓  Y
PgUp PgDn  R1 out, in
Ctrl+PgUp PgDn  R2 out, in
Shift with these  one step</source>
            <translation>← →  Ψ
↑ ↓  Y
PgUp PgDn  R1 退、进
Ctrl+PgUp PgDn  R2 退、进
同时按 Shift  一步</translation>
        </message>
        <message>
            <source>← → Ψ   ↑ ↓ Y   PgUp PgDn R1
Ctrl+PgUp PgDn R2   Shift one step</source>
            <translation>← → Ψ   ↑ ↓ Y   PgUp PgDn R1
Ctrl+PgUp PgDn R2   Shift 一步</translation>
        </message>
        <message>
            <source>≥ %1 mm</source>
            <translation>≥ %1 mm</translation>
        </message>
        <message>
            <source>⌀, round</source>
            <translation>⌀、周长</translation>
        </message>
        <message>
            <source>○ index</source>
            <translation>○ 零位</translation>
        </message>
        <message>
            <source>○ limit</source>
            <translation>○ 限位</translation>
        </message>
        <message>
            <source>● index</source>
            <translation>● 零位</translation>
        </message>
        <message>
            <source>✓ CORE ALIVE</source>
            <translation>✓ 内核正常</translation>
        </message>
    </context>
</TS>
