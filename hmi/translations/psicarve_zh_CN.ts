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
            <source>! CORE LATE</source>
            <translation>! 内核迟滞</translation>
        </message>
        <message>
            <source>! LIMIT</source>
            <translation>! 限位</translation>
        </message>
        <message>
            <source>%1 alone finds its home position</source>
            <translation>%1 单独回零</translation>
        </message>
        <message>
            <source>%1 cannot count so far</source>
            <translation>%1 无法计数到那么远</translation>
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
            <source>%1 entries</source>
            <translation>%1 条记录</translation>
        </message>
        <message>
            <source>%1 found its sensor</source>
            <translation>%1 找到传感器</translation>
        </message>
        <message>
            <source>%1 has no way left in this direction</source>
            <translation>%1 在此方向已无行程</translation>
        </message>
        <message>
            <source>%1 is not a number</source>
            <translation>%1 不是数字</translation>
        </message>
        <message>
            <source>%1 is not a number: a vertex needs three</source>
            <translation>%1 不是数字：一个顶点需要三个数字</translation>
        </message>
        <message>
            <source>%1 is not a word of ASCII STL</source>
            <translation>%1 不是 ASCII STL 的关键字</translation>
        </message>
        <message>
            <source>%1 is not the number of a vertex</source>
            <translation>%1 不是顶点编号</translation>
        </message>
        <message>
            <source>%1 is not wired to any pin</source>
            <translation>%1 未接到任何引脚</translation>
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
            <source>%1 limit switch: closed</source>
            <translation>%1 限位开关：闭合</translation>
        </message>
        <message>
            <source>%1 limit switch: open</source>
            <translation>%1 限位开关：断开</translation>
        </message>
        <message>
            <source>%1 mm</source>
            <translation>%1 mm</translation>
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
            <source>%1 not homed</source>
            <translation>%1 未回零</translation>
        </message>
        <message>
            <source>%1 of %2 facets have no finite coordinates; this is not a usable mesh</source>
            <translation>%2 个面中有 %1 个坐标不是有限数；此网格不可用</translation>
        </message>
        <message>
            <source>%1 of %2 layers do not contain the axis.</source>
            <translation>%2 层中有 %1 层不包含轴心。</translation>
        </message>
        <message>
            <source>%1 of %2 layers do not contain the axis. With Axis at: least lost, %3 of the surface and %4 of the layers would be lost.</source>
            <translation>%2 层中有 %1 层不包含轴心。若“轴心位于”选“损失最少”，将损失 %3 的表面和 %4 的层。</translation>
        </message>
        <message>
            <source>%1 of %2 pass</source>
            <translation>%2 项中 %1 项通过</translation>
        </message>
        <message>
            <source>%1 of the surface lies behind another part and cannot be reached.</source>
            <translation>%1 的表面位于其他部分之后，无法到达。</translation>
        </message>
        <message>
            <source>%1 of the surface lies behind another part and cannot be reached. With Axis at: least lost, %2 of the surface and %3 of the layers would be lost.</source>
            <translation>%1 的表面位于其他部分之后，无法到达。若“轴心位于”选“损失最少”，将损失 %2 的表面和 %3 的层。</translation>
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
            <source>%1 pulses</source>
            <translation>%1 脉冲</translation>
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
            <source>%1 turns</source>
            <translation>%1 圈</translation>
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
            <source>%1 × %2 × %3, %4 facets</source>
            <translation>%1 × %2 × %3，%4 个面片</translation>
        </message>
        <message>
            <source>%1. Lose them?</source>
            <translation>%1。要放弃吗？</translation>
        </message>
        <message>
            <source>%1: homed</source>
            <translation>%1：已回零</translation>
        </message>
        <message>
            <source>%1: not homed</source>
            <translation>%1：未回零</translation>
        </message>
        <message>
            <source>%1: whether it was homed is not recorded</source>
            <translation>%1：是否回零未记录</translation>
        </message>
        <message>
            <source>1 change not saved</source>
            <translation>1 处修改未保存</translation>
        </message>
        <message>
            <source>1 turn</source>
            <translation>1 圈</translation>
        </message>
        <message>
            <source>3 of 3</source>
            <translation>3/3</translation>
        </message>
        <message>
            <source>A head moving in to its first point.</source>
            <translation>刀头进给到第一点的速度。</translation>
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
            <source>ALARM</source>
            <translation>报警</translation>
        </message>
        <message>
            <source>Acceleration that the motor follows (a_k).</source>
            <translation>电机能跟上的加速度（a_k）。</translation>
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
            <source>As the desktop</source>
            <translation>跟随桌面</translation>
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
            <source>BACKING OFF</source>
            <translation>退离中</translation>
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
            <source>Between entries</source>
            <translation>记录之间</translation>
        </message>
        <message>
            <source>Between two points the path may leave the straight line by this.</source>
            <translation>两点之间轨迹可偏离直线这么多。</translation>
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
            <source>By feed and top speeds alone; the core plans it when it is published</source>
            <translation>仅按进给和最高速度估算；发布后由内核规划</translation>
        </message>
        <message>
            <source>By hand</source>
            <translation>手动</translation>
        </message>
        <message>
            <source>CARVING</source>
            <translation>雕刻中</translation>
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
            <source>Carved against wanted: blue too deep, brown material left</source>
            <translation>实际与要求之差：蓝色过深，棕色有余料</translation>
        </message>
        <message>
            <source>Carved piece</source>
            <translation>工件</translation>
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
            <source>Carving time</source>
            <translation>雕刻时间</translation>
        </message>
        <message>
            <source>Check the axis' home sensor, its wire and its pin in the profile; reset the alarm, then home again.</source>
            <translation>检查该轴的回零传感器、接线和配置中的引脚；复位报警，然后重新回零。</translation>
        </message>
        <message>
            <source>Check the port's cable, device and permissions; reset the alarm, then home.</source>
            <translation>检查端口的电缆、设备和权限；复位报警，然后回零。</translation>
        </message>
        <message>
            <source>Check the sensor of axis %1</source>
            <translation>检查轴 %1 的传感器</translation>
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
            <source>Command: %1</source>
            <translation>命令：%1</translation>
        </message>
        <message>
            <source>Compare with defaults</source>
            <translation>与默认值比较</translation>
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
            <source>Dark</source>
            <translation>深色</translation>
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
            <source>Done</source>
            <translation>完成</translation>
        </message>
        <message>
            <source>Drives and spindle are off. No axis moved: home only if one was turned by hand.</source>
            <translation>驱动和主轴已关闭。没有轴移动：只有被手动转动过才需回零。</translation>
        </message>
        <message>
            <source>Drives and spindle are off; the position is not certain any more.</source>
            <translation>驱动和主轴已关闭；位置不再可靠。</translation>
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
            <source>EMERGENCY STOP</source>
            <translation>急停</translation>
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
            <source>End</source>
            <translation>结尾</translation>
        </message>
        <message>
            <source>End at which the limit sensor stands.</source>
            <translation>限位传感器所在的一端。</translation>
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
            <source>Every pulse</source>
            <translation>每个脉冲</translation>
        </message>
        <message>
            <source>F1  emergency stop, everywhere
Esc  stop, everywhere, while the machine is at work
Ctrl+Enter  start
Pause  hold, resume
Ctrl+Home  home all
Ctrl+0, Ctrl+−, Ctrl++  feed override
Ctrl+O  open
F5  slice
F9  arm keyboard jog
Ctrl+1 … 7  tabs
Ctrl+L  layer number
F6  next pane
F10  menu
F12  this list

Replay: K  play, pause
J, L  slower, faster
N, Shift+N  next entry, entry before
,  .  one layer
On the timeline: arrows, Page Up, Page Down, Home, End</source>
            <translation>F1  急停，任何地方有效
Esc  停止，机床工作时任何地方有效
Ctrl+Enter  启动
Pause  暂停、继续
Ctrl+Home  全部回零
Ctrl+0、Ctrl+−、Ctrl++  进给倍率
Ctrl+O  打开
F5  切片
F9  启用键盘点动
Ctrl+1 … 7  页面
Ctrl+L  层号
F6  下一窗格
F10  菜单
F12  本列表

回放：K  播放、暂停
J、L  慢、快
N、Shift+N  下一条、上一条记录
,  .  一层
在时间轴上：方向键、Page Up、Page Down、Home、End</translation>
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
            <source>Find a key</source>
            <translation>查找参数</translation>
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
            <source>Folder for the support bundle</source>
            <translation>支持包的文件夹</translation>
        </message>
        <message>
            <source>Forgets the zero of %1</source>
            <translation>清除 %1 的显示零点</translation>
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
            <source>From the flight recorder. A click goes to an entry.</source>
            <translation>来自飞行记录。单击转到该条。</translation>
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
            <source>General</source>
            <translation>常规</translation>
        </message>
        <message>
            <source>Gives the job to the core, which checks it</source>
            <translation>把作业交给内核检查</translation>
        </message>
        <message>
            <source>Greatest difference at an index pass that is not the alarm steps lost.</source>
            <translation>经过零位时不触发“丢步”报警的最大偏差。</translation>
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
            <source>Heads move out this far after the last point and on stop.</source>
            <translation>最后一点之后及停止时刀头退出的距离。</translation>
        </message>
        <message>
            <source>Heads out, spindle off</source>
            <translation>刀头退出，主轴关闭</translation>
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
            <source>Height, radius</source>
            <translation>高度，半径</translation>
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
            <source>Home Ψ: home R1 and R2 first</source>
            <translation>Ψ 回零：请先将 R1 和 R2 回零</translation>
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
            <source>How far past the sensor the mechanics allow.</source>
            <translation>机械结构允许越过传感器的距离。</translation>
        </message>
        <message>
            <source>How late ticks were: number of ticks by lateness</source>
            <translation>节拍迟滞：按迟滞量统计的节拍数</translation>
        </message>
        <message>
            <source>How many pulses</source>
            <translation>脉冲数</translation>
        </message>
        <message>
            <source>How much higher R2 stands than R1, measured once.</source>
            <translation>R2 比 R1 高出多少，一次性测得。</translation>
        </message>
        <message>
            <source>IDLE</source>
            <translation>空闲</translation>
        </message>
        <message>
            <source>In the file: %1</source>
            <translation>文件中为：%1</translation>
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
            <source>Iso</source>
            <translation>轴测</translation>
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
            <source>Job in travel</source>
            <translation>作业在行程内</translation>
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
            <source>Job: %1 × %2 points</source>
            <translation>作业：%1 × %2 点</translation>
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
            <source>Joining</source>
            <translation>层间连接</translation>
        </message>
        <message>
            <source>Keys</source>
            <translation>按键</translation>
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
            <source>Language</source>
            <translation>语言</translation>
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
            <source>Layer %1 / %2, point %3 / %4</source>
            <translation>层 %1 / %2，点 %3 / %4</translation>
        </message>
        <message>
            <source>Layer %1 of %2</source>
            <translation>第 %1 层，共 %2 层</translation>
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
            <source>Leaves out the layers before it</source>
            <translation>跳过它之前的层</translation>
        </message>
        <message>
            <source>Leaves replay and opens the job in this snapshot</source>
            <translation>退出回放并打开快照中的作业</translation>
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
            <source>Light: carved (%1 layers not seen: as planned). Dark: blank.</source>
            <translation>浅：已雕刻（%1 层未见到：按计划显示）。深：毛坯。</translation>
        </message>
        <message>
            <source>Light: carved, as planned. Dark: blank.</source>
            <translation>浅：已雕刻，按计划。深：毛坯。</translation>
        </message>
        <message>
            <source>Light: carved. Dark: blank.</source>
            <translation>浅：已雕刻。深：毛坯。</translation>
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
            <source>Live machine: %1</source>
            <translation>实际机床：%1</translation>
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
            <source>Locked until the alarm is reset</source>
            <translation>报警复位前锁定</translation>
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
            <source>Logical levels, looked at 30 times a second; steps by how many there were in between. A trace (--trace) holds every edge.</source>
            <translation>逻辑电平，每秒查看 30 次；步进按其间的数量显示。轨迹文件（--trace）记录每个边沿。</translation>
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
            <source>Looking for the sensors</source>
            <translation>正在寻找传感器</translation>
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
            <source>MOVING</source>
            <translation>移动中</translation>
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
            <source>Menu</source>
            <translation>菜单</translation>
        </message>
        <message>
            <source>Menu (F10)</source>
            <translation>菜单（F10）</translation>
        </message>
        <message>
            <source>Messages</source>
            <translation>消息</translation>
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
            <source>Model</source>
            <translation>模型</translation>
        </message>
        <message>
            <source>Models and jobs (*.stl *.obj *.ply *.3mf *.off *.job *.psi);;Recordings (*.snap *.trace);;All files (*)</source>
            <translation>模型和作业 (*.stl *.obj *.ply *.3mf *.off *.job *.psi);;记录 (*.snap *.trace);;所有文件 (*)</translation>
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
            <source>NO CORE</source>
            <translation>无内核</translation>
        </message>
        <message>
            <source>Name of the machine, for people.</source>
            <translation>机床名称，供人识别。</translation>
        </message>
        <message>
            <source>No alarm</source>
            <translation>无报警</translation>
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
            <source>No core: these are the last figures known</source>
            <translation>无内核：这些是最后已知的数值</translation>
        </message>
        <message>
            <source>No core: these are the last levels known.</source>
            <translation>无内核：这些是最后已知的电平。</translation>
        </message>
        <message>
            <source>No core: use the switch on the machine</source>
            <translation>无内核：请使用机床上的开关</translation>
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
            <source>No zero</source>
            <translation>清除 Δ</translation>
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
            <source>Not saved: %1</source>
            <translation>未保存：%1</translation>
        </message>
        <message>
            <source>Not sliced yet.</source>
            <translation>尚未切片。</translation>
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
            <source>Nothing is open.</source>
            <translation>没有打开的文件。</translation>
        </message>
        <message>
            <source>Nothing is wrong.</source>
            <translation>一切正常。</translation>
        </message>
        <message>
            <source>Of top speed</source>
            <translation>占最高速度</translation>
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
            <source>Open a machine profile</source>
            <translation>打开机床配置</translation>
        </message>
        <message>
            <source>Open its job</source>
            <translation>打开其作业</translation>
        </message>
        <message>
            <source>Open model, job or recording</source>
            <translation>打开模型、作业或记录</translation>
        </message>
        <message>
            <source>Open model, job or recording…</source>
            <translation>打开模型、作业或记录…</translation>
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
            <source>OpenGL took the window down the last time: drawing without it</source>
            <translation>上次 OpenGL 使窗口崩溃：现在不用它绘图</translation>
        </message>
        <message>
            <source>Opened %1</source>
            <translation>已打开 %1</translation>
        </message>
        <message>
            <source>Opened, not sliced yet: %1</source>
            <translation>已打开、尚未切片：%1</translation>
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
            <source>POSITIONING</source>
            <translation>定位中</translation>
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
            <source>Pause</source>
            <translation>暂停</translation>
        </message>
        <message>
            <source>Period of the core's base tick; pins change only at ticks.</source>
            <translation>内核基本节拍的周期；引脚只在节拍处变化。</translation>
        </message>
        <message>
            <source>Pin</source>
            <translation>引脚</translation>
        </message>
        <message>
            <source>Placement and slicing</source>
            <translation>摆放与切片</translation>
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
            <source>Points / head</source>
            <translation>点数 / 刀头</translation>
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
            <source>Profile</source>
            <translation>配置</translation>
        </message>
        <message>
            <source>Profile not saved: %1</source>
            <translation>配置未保存：%1</translation>
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
            <source>Pulses of the job</source>
            <translation>作业脉冲</translation>
        </message>
        <message>
            <source>Pulses per second R1, R2, Ψ, Y</source>
            <translation>每秒脉冲 R1、R2、Ψ、Y</translation>
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
            <source>R1 step</source>
            <translation>R1 步进</translation>
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
            <source>R2 step</source>
            <translation>R2 步进</translation>
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
            <source>Radii of all layers, unrolled</source>
            <translation>所有层的半径展开图</translation>
        </message>
        <message>
            <source>Radius</source>
            <translation>半径</translation>
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
            <source>Reading the recording</source>
            <translation>读取记录</translation>
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
            <source>Recorded levels at the entries of the flight recorder. Steps are not in a snapshot.</source>
            <translation>飞行记录各条时的电平。快照中没有步进。</translation>
        </message>
        <message>
            <source>Recorded levels of the 20 seconds before this moment.</source>
            <translation>此刻之前 20 秒的记录电平。</translation>
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
            <source>Report saved: %1</source>
            <translation>报告已保存：%1</translation>
        </message>
        <message>
            <source>Report: %1</source>
            <translation>报告：%1</translation>
        </message>
        <message>
            <source>Report: no job was started</source>
            <translation>报告：尚未启动作业</translation>
        </message>
        <message>
            <source>Report: the job is not known</source>
            <translation>报告：作业未知</translation>
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
            <source>Reset the alarm, then home.</source>
            <translation>复位报警，然后回零。</translation>
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
            <source>SIMULATOR</source>
            <translation>仿真</translation>
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
            <source>Save as JSON…</source>
            <translation>另存为 JSON…</translation>
        </message>
        <message>
            <source>Save as...</source>
            <translation>另存为...</translation>
        </message>
        <message>
            <source>Save log…</source>
            <translation>保存日志…</translation>
        </message>
        <message>
            <source>Save the log</source>
            <translation>保存日志</translation>
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
            <source>Save: %1 values are wrong</source>
            <translation>保存：%1 个值有误</translation>
        </message>
        <message>
            <source>Save: one value is wrong</source>
            <translation>保存：一个值有误</translation>
        </message>
        <message>
            <source>Save: the machine moves</source>
            <translation>保存：机床在运动</translation>
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
            <source>Section at Y %1 mm, radius in mm</source>
            <translation>Y %1 mm 处的截面，半径单位 mm</translation>
        </message>
        <message>
            <source>Section of the layer, seen from above</source>
            <translation>层截面，俯视</translation>
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
            <source>Show</source>
            <translation>显示</translation>
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
            <source>Side</source>
            <translation>侧</translation>
        </message>
        <message>
            <source>Signal</source>
            <translation>信号</translation>
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
            <source>Sliced, not published yet: %1</source>
            <translation>已切片、尚未发布：%1</translation>
        </message>
        <message>
            <source>Slicing …</source>
            <translation>正在切片 …</translation>
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
            <source>Spindle on</source>
            <translation>主轴开</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>启动</translation>
        </message>
        <message>
            <source>Start from layer %1</source>
            <translation>从第 %1 层启动</translation>
        </message>
        <message>
            <source>Start from layer %1: the layers below are left as they are. The heads go out, Y goes to the layer, then the heads go in at plunge speed.</source>
            <translation>从第 %1 层启动：下面的层保持原样。刀头先退出，Y 移到该层，然后刀头以切入速度进给。</translation>
        </message>
        <message>
            <source>Start it again; home before carving on</source>
            <translation>重新启动它；继续雕刻前先回零</translation>
        </message>
        <message>
            <source>Start psicarve-rtcore</source>
            <translation>启动 psicarve-rtcore</translation>
        </message>
        <message>
            <source>Start: a job is being made</source>
            <translation>启动：正在生成作业</translation>
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
            <source>Start: axis %1 is not homed</source>
            <translation>启动：轴 %1 未回零</translation>
        </message>
        <message>
            <source>Start: no job is published</source>
            <translation>启动：没有已发布的作业</translation>
        </message>
        <message>
            <source>Start: on hold; resume or stop</source>
            <translation>启动：已暂停；请继续或停止</translation>
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
            <source>Start: the heads are on their way</source>
            <translation>启动：刀头正在移动就位</translation>
        </message>
        <message>
            <source>Start: the heads are on their way out</source>
            <translation>启动：刀头正在退出</translation>
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
            <source>Stop</source>
            <translation>停止</translation>
        </message>
        <message>
            <source>Stop asked for</source>
            <translation>已请求停止</translation>
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
            <source>Support bundle: %1</source>
            <translation>支持包：%1</translation>
        </message>
        <message>
            <source>Support bundle…</source>
            <translation>支持包…</translation>
        </message>
        <message>
            <source>Switch %1 is still closed</source>
            <translation>开关 %1 仍闭合</translation>
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
            <source>Take backup</source>
            <translation>恢复备份</translation>
        </message>
        <message>
            <source>Text (*.log *.txt)</source>
            <translation>文本 (*.log *.txt)</translation>
        </message>
        <message>
            <source>The blank as carved so far</source>
            <translation>目前雕刻到的毛坯</translation>
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
            <source>The core has this job.</source>
            <translation>内核已有此作业。</translation>
        </message>
        <message>
            <source>The core is silent</source>
            <translation>内核无响应</translation>
        </message>
        <message>
            <source>The core is silent: use the switch on the machine</source>
            <translation>内核无响应：请使用机床上的开关</translation>
        </message>
        <message>
            <source>The core runs on a virtual clock: no tick is ever late</source>
            <translation>内核使用虚拟时钟：节拍从不迟滞</translation>
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
            <source>The gap between two step pulses lasts at least this long.</source>
            <translation>两个步进脉冲之间的间隔至少这么久。</translation>
        </message>
        <message>
            <source>The guard process ended: start the core again.</source>
            <translation>守护进程已结束：请重新启动内核。</translation>
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
            <source>The language changes when the window is opened the next time</source>
            <translation>下次打开窗口时更换语言</translation>
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
            <source>The machine is at work. It does not need this window: what is to become of it?</source>
            <translation>机床正在工作。它不需要此窗口：要如何处理？</translation>
        </message>
        <message>
            <source>The machine's profile is not known here: pins are those of the built-in profile.</source>
            <translation>此处不知道机床配置：引脚按内置配置显示。</translation>
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
            <source>The model stands so far from its file's origin that its coordinates are rounded to %1 mm, more than a pulse (%2 mm): move it to the origin before it is exported.</source>
            <translation>模型离文件原点太远，坐标被舍入到 %1 mm，超过一个脉冲（%2 mm）：导出前请移到原点。</translation>
        </message>
        <message>
            <source>The old file is kept as a backup. A core takes a profile when it starts.</source>
            <translation>旧文件保留为备份。内核在启动时读取配置。</translation>
        </message>
        <message>
            <source>The shared memory was removed or damaged from outside: reset the alarm and publish the job again.</source>
            <translation>共享内存被外部删除或损坏：复位报警并重新发布作业。</translation>
        </message>
        <message>
            <source>The table has lost steps</source>
            <translation>转台丢步</translation>
        </message>
        <message>
            <source>The table keeps turning, runs to and fro, or the heads rise as it turns, without links; a job carries its own.</source>
            <translation>转台持续转动、往复转动，或刀头随转动上升而无层间连接；作业自带此设置。</translation>
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
            <source>Tick</source>
            <translation>节拍</translation>
        </message>
        <message>
            <source>Ticks by how late they were (logarithmic)</source>
            <translation>按迟滞量统计的节拍（对数）</translation>
        </message>
        <message>
            <source>Ticks in which a step waited for its pin</source>
            <translation>步进等待引脚的节拍</translation>
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
            <source>Time</source>
            <translation>时间</translation>
        </message>
        <message>
            <source>Timeline of the recording</source>
            <translation>记录时间轴</translation>
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
            <source>Tool over surface; a job carries its own.</source>
            <translation>刀具相对表面的速度；作业自带此设置。</translation>
        </message>
        <message>
            <source>Top</source>
            <translation>上</translation>
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
            <source>Touch-off: the real tip stands this much further out than counted.</source>
            <translation>对刀：实际刀尖比计数位置更靠外的量。</translation>
        </message>
        <message>
            <source>Undo all</source>
            <translation>全部撤销</translation>
        </message>
        <message>
            <source>Unrolled Ψ–Y map of radii</source>
            <translation>Ψ–Y 半径展开图</translation>
        </message>
        <message>
            <source>Up axis</source>
            <translation>向上的轴</translation>
        </message>
        <message>
            <source>Use the switch on the machine to stop it</source>
            <translation>请用机床上的开关停机</translation>
        </message>
        <message>
            <source>Verified</source>
            <translation>已校验</translation>
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
            <source>Warnings and alarms</source>
            <translation>警告和报警</translation>
        </message>
        <message>
            <source>What happened</source>
            <translation>发生了什么</translation>
        </message>
        <message>
            <source>What to do</source>
            <translation>如何处理</translation>
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
            <source>Wiring test</source>
            <translation>接线测试</translation>
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
            <source>Working the piece out: %1 %</source>
            <translation>正在计算工件：%1 %</translation>
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
            <source>Zero: axis %1 is not homed</source>
            <translation>设零：轴 %1 未回零</translation>
        </message>
        <message>
            <source>Zero: the machine's profile is not known here</source>
            <translation>设零：此处不知道机床配置</translation>
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
            <source>a recorded run is being replayed</source>
            <translation>正在重放已记录的运行</translation>
        </message>
        <message>
            <source>a recording is shown; leave replay first</source>
            <translation>正在显示记录；请先退出回放</translation>
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
            <source>an output is being tested; end the test first</source>
            <translation>正在测试一个输出；请先结束测试</translation>
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
            <source>as planned</source>
            <translation>按计划</translation>
        </message>
        <message>
            <source>assumed</source>
            <translation>假定</translation>
        </message>
        <message>
            <source>at least %1</source>
            <translation>至少 %1</translation>
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
            <source>became shorter while it was read</source>
            <translation>读取时文件变短</translation>
        </message>
        <message>
            <source>being made</source>
            <translation>正在生成</translation>
        </message>
        <message>
            <source>blank ⌀ %1</source>
            <translation>毛坯 ⌀ %1</translation>
        </message>
        <message>
            <source>box centre</source>
            <translation>包围盒中心</translation>
        </message>
        <message>
            <source>built-in profile</source>
            <translation>内置配置</translation>
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
            <source>carved to the last point</source>
            <translation>已雕刻到最后一点</translation>
        </message>
        <message>
            <source>carving</source>
            <translation>雕刻中</translation>
        </message>
        <message>
            <source>checked</source>
            <translation>已检查</translation>
        </message>
        <message>
            <source>core lost</source>
            <translation>内核丢失</translation>
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
            <source>done</source>
            <translation>完成</translation>
        </message>
        <message>
            <source>drives-off</source>
            <translation>关闭驱动</translation>
        </message>
        <message>
            <source>emergency stop</source>
            <translation>急停</translation>
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
            <source>from here on a tick may have been missed</source>
            <translation>从此处起可能丢失节拍</translation>
        </message>
        <message>
            <source>from the pins</source>
            <translation>由引脚得出</translation>
        </message>
        <message>
            <source>granted</source>
            <translation>已授予</translation>
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
            <source>height</source>
            <translation>高度</translation>
        </message>
        <message>
            <source>held</source>
            <translation>已暂停</translation>
        </message>
        <message>
            <source>high</source>
            <translation>高</translation>
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
            <source>in it</source>
            <translation>已包含</translation>
        </message>
        <message>
            <source>info</source>
            <translation>信息</translation>
        </message>
        <message>
            <source>is a folder, not a model file</source>
            <translation>是文件夹，不是模型文件</translation>
        </message>
        <message>
            <source>is a zip archive, but holds no 3MF model</source>
            <translation>是 zip 压缩包，但不含 3MF 模型</translation>
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
            <source>is not a regular file</source>
            <translation>不是普通文件</translation>
        </message>
        <message>
            <source>jog</source>
            <translation>点动</translation>
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
            <source>layer %1, point %2: the radius of %3, %4, is inside the core radius of %5; carve less deep, or lower core_radius_mm</source>
            <translation>第 %1 层第 %2 点：%3 的半径 %4 在芯半径 %5 之内；请雕浅一些，或减小 core_radius_mm</translation>
        </message>
        <message>
            <source>least lost</source>
            <translation>损失最少</translation>
        </message>
        <message>
            <source>left</source>
            <translation>左</translation>
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
            <source>linear</source>
            <translation>直线</translation>
        </message>
        <message>
            <source>locked</source>
            <translation>锁定</translation>
        </message>
        <message>
            <source>looking for the best axis was cancelled</source>
            <translation>已取消寻找最佳轴线</translation>
        </message>
        <message>
            <source>low</source>
            <translation>低</translation>
        </message>
        <message>
            <source>missed %1</source>
            <translation>丢失 %1</translation>
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
            <source>more layers than pulses: %1 layers, but the model is only %2 mm, %3 pulses of axis Y, high: choose at most %4 layers, or a larger height</source>
            <translation>层数多于脉冲：%1 层，但模型只有 %2 mm 高，即 Y 轴 %3 个脉冲：最多选 %4 层，或选更大的高度</translation>
        </message>
        <message>
            <source>more points than pulses: %1 points a layer, but half a turn of axis Ψ has %2 pulses: choose at most %3 points</source>
            <translation>点数多于脉冲：每层 %1 点，但 Ψ 轴半圈只有 %2 个脉冲：最多选 %3 点</translation>
        </message>
        <message>
            <source>move</source>
            <translation>移动</translation>
        </message>
        <message>
            <source>moving</source>
            <translation>移动中</translation>
        </message>
        <message>
            <source>no core</source>
            <translation>无内核</translation>
        </message>
        <message>
            <source>no core serves segment %1</source>
            <translation>没有内核服务于共享段 %1</translation>
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
            <source>no pin</source>
            <translation>无引脚</translation>
        </message>
        <message>
            <source>no such file</source>
            <translation>没有此文件</translation>
        </message>
        <message>
            <source>no. %1</source>
            <translation>%1 号</translation>
        </message>
        <message>
            <source>none</source>
            <translation>无</translation>
        </message>
        <message>
            <source>none: add it</source>
            <translation>无：请添加</translation>
        </message>
        <message>
            <source>none: ticks may be late</source>
            <translation>无：节拍可能迟滞</translation>
        </message>
        <message>
            <source>not a mesh that can be read here (STL, OBJ, PLY, 3MF or OFF)</source>
            <translation>不是此处可读的网格（STL、OBJ、PLY、3MF 或 OFF）</translation>
        </message>
        <message>
            <source>not by the window; psicarve carve does</source>
            <translation>窗口不校验；psicarve carve 会校验</translation>
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
            <source>not needed</source>
            <translation>不需要</translation>
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
            <source>of %1</source>
            <translation>共 %1</translation>
        </message>
        <message>
            <source>off</source>
            <translation>关闭</translation>
        </message>
        <message>
            <source>only in a trace</source>
            <translation>仅在轨迹中</translation>
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
            <source>opening was cancelled</source>
            <translation>已取消打开</translation>
        </message>
        <message>
            <source>out</source>
            <translation>出</translation>
        </message>
        <message>
            <source>override</source>
            <translation>倍率</translation>
        </message>
        <message>
            <source>passed</source>
            <translation>通过</translation>
        </message>
        <message>
            <source>plan starved</source>
            <translation>规划供不应求</translation>
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
            <source>profile %1</source>
            <translation>配置 %1</translation>
        </message>
        <message>
            <source>profile unknown</source>
            <translation>配置未知</translation>
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
            <source>radius %1 to %2 mm</source>
            <translation>半径 %1 到 %2 mm</translation>
        </message>
        <message>
            <source>reachable</source>
            <translation>可到达</translation>
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
            <source>record</source>
            <translation>记录</translation>
        </message>
        <message>
            <source>recorded</source>
            <translation>已记录</translation>
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
            <source>right</source>
            <translation>右</translation>
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
            <source>shutdown</source>
            <translation>关闭内核</translation>
        </message>
        <message>
            <source>silent</source>
            <translation>无响应</translation>
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
            <source>spindle</source>
            <translation>主轴</translation>
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
            <source>start, or stop</source>
            <translation>请启动或停止</translation>
        </message>
        <message>
            <source>start-interpolation</source>
            <translation>开始雕刻</translation>
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
            <source>stopped</source>
            <translation>已停止</translation>
        </message>
        <message>
            <source>stopping</source>
            <translation>停止中</translation>
        </message>
        <message>
            <source>test-pin</source>
            <translation>引脚测试</translation>
        </message>
        <message>
            <source>testing</source>
            <translation>测试中</translation>
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
            <source>the core did not answer within %1 ms</source>
            <translation>内核在 %1 ms 内没有回答</translation>
        </message>
        <message>
            <source>the core ended before it answered</source>
            <translation>内核在回答之前已结束</translation>
        </message>
        <message>
            <source>the core of segment %1 (process %2) is silent</source>
            <translation>共享段 %1 的内核（进程 %2）没有响应</translation>
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
            <source>the file is empty</source>
            <translation>文件为空</translation>
        </message>
        <message>
            <source>the job has not so many layers</source>
            <translation>作业没有这么多层</translation>
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
            <source>the machine came to rest (%1), somebody stopped it</source>
            <translation>机床已停下（%1），有人停止了它</translation>
        </message>
        <message>
            <source>the machine is not homed; home first</source>
            <translation>机床未回零；请先回零</translation>
        </message>
        <message>
            <source>the mesh has no volume (all of it is flat); there is nothing to carve</source>
            <translation>网格没有体积（全部是平的）；没有可雕刻的内容</translation>
        </message>
        <message>
            <source>the switch of the axis is open; there is nothing to back off from</source>
            <translation>此轴的开关未闭合；无需退离</translation>
        </message>
        <message>
            <source>the zip archive is cut off or damaged</source>
            <translation>zip 压缩包被截断或已损坏</translation>
        </message>
        <message>
            <source>there is no alarm</source>
            <translation>没有报警</translation>
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
            <source>under way</source>
            <translation>进行中</translation>
        </message>
        <message>
            <source>undercut %1 %</source>
            <translation>倒扣 %1 %</translation>
        </message>
        <message>
            <source>unknown</source>
            <translation>未知</translation>
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
            <source>waiting</source>
            <translation>等待中</translation>
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
            <source>whole</source>
            <translation>完整</translation>
        </message>
        <message>
            <source>× NO CORE</source>
            <translation>× 无内核</translation>
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
            <source>Ψ index: there</source>
            <translation>Ψ 零位：在</translation>
        </message>
        <message>
            <source>Ψ step</source>
            <translation>Ψ 步进</translation>
        </message>
        <message>
            <source>← → Ψ   ↑ ↓ Y   PgUp PgDn R1
Ctrl+PgUp PgDn R2   Shift one step</source>
            <translation>← → Ψ   ↑ ↓ Y   PgUp PgDn R1
Ctrl+PgUp PgDn R2   Shift 一步</translation>
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
