<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru" sourcelanguage="en">
    <context>
        <name>psicarve</name>
        <message>
            <source> of %1</source>
            <translation> из %1</translation>
        </message>
        <message>
            <source>! CORE LATE</source>
            <translation>! ЯДРО ЗАПАЗДЫВАЕТ</translation>
        </message>
        <message>
            <source>! LIMIT</source>
            <translation>! КВ</translation>
        </message>
        <message>
            <source>%1 alone finds its home position</source>
            <translation>%1 один ищет свой ноль</translation>
        </message>
        <message>
            <source>%1 cannot count so far</source>
            <translation>%1 не может отсчитать так далеко</translation>
        </message>
        <message>
            <source>%1 changes</source>
            <translation>%1 фронтов</translation>
        </message>
        <message>
            <source>%1 changes not saved</source>
            <translation>не сохранено изменений: %1</translation>
        </message>
        <message>
            <source>%1 closed</source>
            <translation>%1 замкнут</translation>
        </message>
        <message>
            <source>%1 entries</source>
            <translation>записей: %1</translation>
        </message>
        <message>
            <source>%1 found its sensor</source>
            <translation>%1: датчик найден</translation>
        </message>
        <message>
            <source>%1 has no way left in this direction</source>
            <translation>у %1 в эту сторону больше нет хода</translation>
        </message>
        <message>
            <source>%1 is not a number</source>
            <translation>%1 — не число</translation>
        </message>
        <message>
            <source>%1 is not a number: a vertex needs three</source>
            <translation>%1 — не число: вершине нужны три</translation>
        </message>
        <message>
            <source>%1 is not a word of ASCII STL</source>
            <translation>%1 — не слово текстового STL</translation>
        </message>
        <message>
            <source>%1 is not the number of a vertex</source>
            <translation>%1 — не номер вершины</translation>
        </message>
        <message>
            <source>%1 is not wired to any pin</source>
            <translation>%1 не подключён ни к одному контакту</translation>
        </message>
        <message>
            <source>%1 layers, not %2: %3 is only %4 mm high, and a layer needs a pulse of axis Y</source>
            <translation>слоёв %1, а не %2: высота %3 лишь %4 mm, а слою нужен импульс оси Y</translation>
        </message>
        <message>
            <source>%1 left</source>
            <translation>осталось %1</translation>
        </message>
        <message>
            <source>%1 limit switch: closed</source>
            <translation>концевой выключатель %1: замкнут</translation>
        </message>
        <message>
            <source>%1 limit switch: open</source>
            <translation>концевой выключатель %1: разомкнут</translation>
        </message>
        <message>
            <source>%1 mm</source>
            <translation>%1 mm</translation>
        </message>
        <message>
            <source>%1 mm, r ≤ %2</source>
            <translation>%1 mm, r ≤ %2</translation>
        </message>
        <message>
            <source>%1 mm/s</source>
            <translation>%1 mm/s</translation>
        </message>
        <message>
            <source>%1 not homed</source>
            <translation>нет: %1</translation>
        </message>
        <message>
            <source>%1 of %2 facets have no finite coordinates; this is not a usable mesh</source>
            <translation>у %1 из %2 граней координаты не конечны; такая сетка непригодна</translation>
        </message>
        <message>
            <source>%1 of %2 layers do not contain the axis.</source>
            <translation>Слоёв, не содержащих ось: %1 из %2.</translation>
        </message>
        <message>
            <source>%1 of %2 layers do not contain the axis. With Axis at: least lost, %3 of the surface and %4 of the layers would be lost.</source>
            <translation>Слоёв, не содержащих ось: %1 из %2. С «Ось проходит: мин. потеря» потеря составит %3 поверхности и %4 слоёв.</translation>
        </message>
        <message>
            <source>%1 of %2 pass</source>
            <translation>пройдено %1 из %2</translation>
        </message>
        <message>
            <source>%1 of the surface lies behind another part and cannot be reached.</source>
            <translation>%1 поверхности заслонено другой частью и недостижимо.</translation>
        </message>
        <message>
            <source>%1 of the surface lies behind another part and cannot be reached. With Axis at: least lost, %2 of the surface and %3 of the layers would be lost.</source>
            <translation>%1 поверхности заслонено другой частью и недостижимо. С «Ось проходит: мин. потеря» потеря составит %2 поверхности и %3 слоёв.</translation>
        </message>
        <message>
            <source>%1 planned</source>
            <translation>по плану %1</translation>
        </message>
        <message>
            <source>%1 points a layer, not %2: half a turn of axis Ψ has no more pulses</source>
            <translation>точек в слое %1, а не %2: в половине оборота оси Ψ больше импульсов нет</translation>
        </message>
        <message>
            <source>%1 pulses</source>
            <translation>импульсов: %1</translation>
        </message>
        <message>
            <source>%1 ticks missed</source>
            <translation>Пропущено тактов: %1</translation>
        </message>
        <message>
            <source>%1 ticks missed in the last second</source>
            <translation>за последнюю секунду пропущено тактов: %1</translation>
        </message>
        <message>
            <source>%1 turns</source>
            <translation>%1 об.</translation>
        </message>
        <message>
            <source>%1 would bring the tips closer than head_clearance_mm, %2</source>
            <translation>%1 сблизил бы резцы меньше чем на head_clearance_mm, %2</translation>
        </message>
        <message>
            <source>%1 would go inside the core radius, %2</source>
            <translation>%1 вошёл бы внутрь радиуса сердцевины, %2</translation>
        </message>
        <message>
            <source>%1 would leave its travel, %2 to %3</source>
            <translation>%1 вышел бы за пределы хода, от %2 до %3</translation>
        </message>
        <message>
            <source>%1 × %2 × %3, %4 facets</source>
            <translation>%1 × %2 × %3, %4</translation>
        </message>
        <message>
            <source>%1. Lose them?</source>
            <translation>%1. Отказаться от них?</translation>
        </message>
        <message>
            <source>%1: homed</source>
            <translation>%1: ноль найден</translation>
        </message>
        <message>
            <source>%1: not homed</source>
            <translation>%1: ноль не найден</translation>
        </message>
        <message>
            <source>%1: whether it was homed is not recorded</source>
            <translation>%1: найден ли ноль, не записано</translation>
        </message>
        <message>
            <source>1 change not saved</source>
            <translation>не сохранено одно изменение</translation>
        </message>
        <message>
            <source>1 turn</source>
            <translation>1 об.</translation>
        </message>
        <message>
            <source>3 of 3</source>
            <translation>3 из 3</translation>
        </message>
        <message>
            <source>A head moving in to its first point.</source>
            <translation>Скорость подвода головки к первой точке.</translation>
        </message>
        <message>
            <source>A sensor counts once it has stood this long; the emergency stop is never filtered.</source>
            <translation>Датчик считается сработавшим, если сигнал держится столько; аварийный останов не фильтруется никогда.</translation>
        </message>
        <message>
            <source>A step pulse ends at a later tick, or after a wait inside its own: one pulse a tick.</source>
            <translation>Шаговый импульс заканчивается на следующем такте или после выдержки внутри своего: импульс за такт.</translation>
        </message>
        <message>
            <source>A step pulse lasts at least this long.</source>
            <translation>Шаговый импульс длится не меньше.</translation>
        </message>
        <message>
            <source>ALARM</source>
            <translation>АВАРИЯ</translation>
        </message>
        <message>
            <source>Acceleration that the motor follows (a_k).</source>
            <translation>Ускорение, за которым поспевает двигатель (a_k).</translation>
        </message>
        <message>
            <source>Active low</source>
            <translation>Активный низкий</translation>
        </message>
        <message>
            <source>Add its job…</source>
            <translation>Добавить задание…</translation>
        </message>
        <message>
            <source>Alarm</source>
            <translation>Авария</translation>
        </message>
        <message>
            <source>Alarm: %1</source>
            <translation>Авария: %1</translation>
        </message>
        <message>
            <source>Alarm: %1 of %2</source>
            <translation>Авария: %1, %2</translation>
        </message>
        <message>
            <source>Alarms</source>
            <translation>Аварии</translation>
        </message>
        <message>
            <source>All</source>
            <translation>Все</translation>
        </message>
        <message>
            <source>Arm</source>
            <translation>Включить</translation>
        </message>
        <message>
            <source>Arm keyboard jog</source>
            <translation>Включить клавиши</translation>
        </message>
        <message>
            <source>Armed for one output, all others off. Ends after 30 s, on focus loss or F1.</source>
            <translation>Доступен один выход, прочие выключены. Конец через 30 с, при потере фокуса или по F1.</translation>
        </message>
        <message>
            <source>As fast as every motor can follow, or the original's acceleration segments.</source>
            <translation>Так быстро, как успевают двигатели, или участки разгона прежней машины.</translation>
        </message>
        <message>
            <source>As the desktop</source>
            <translation>Как в системе</translation>
        </message>
        <message>
            <source>At the first point</source>
            <translation>У первой точки</translation>
        </message>
        <message>
            <source>Axes homed</source>
            <translation>Нули осей</translation>
        </message>
        <message>
            <source>Axis</source>
            <translation>Ось</translation>
        </message>
        <message>
            <source>Axis %1 stood at %2. The pause was longer than its motor coasts: it may have lost steps.</source>
            <translation>Ось %1 стояла на %2. Пауза дольше выбега её двигателя: он мог потерять шаги.</translation>
        </message>
        <message>
            <source>Axis %1 stopped at %2. Likely a chip or a broken wire at the switch, or lost steps.</source>
            <translation>Ось %1 остановилась на %2. Вероятно, стружка или обрыв провода у выключателя либо потеря шагов.</translation>
        </message>
        <message>
            <source>Axis %1 stopped at %2; its switch stands at %3 mm. Likely a chip or a broken wire at the switch, or %1 has lost steps.</source>
            <translation>Ось %1 остановилась на %2; её выключатель стоит на %3 mm. Вероятно, стружка или обрыв провода у выключателя либо %1 потеряла шаги.</translation>
        </message>
        <message>
            <source>Axis R1</source>
            <translation>Ось R1</translation>
        </message>
        <message>
            <source>Axis R2</source>
            <translation>Ось R2</translation>
        </message>
        <message>
            <source>Axis Y</source>
            <translation>Ось Y</translation>
        </message>
        <message>
            <source>Axis at</source>
            <translation>Ось проходит</translation>
        </message>
        <message>
            <source>Axis Ψ</source>
            <translation>Ось Ψ</translation>
        </message>
        <message>
            <source>BACKING OFF</source>
            <translation>ОТВОД</translation>
        </message>
        <message>
            <source>Back off</source>
            <translation>Отвести</translation>
        </message>
        <message>
            <source>Back off: no switch is closed</source>
            <translation>Отвести: ни один выключатель не замкнут</translation>
        </message>
        <message>
            <source>Back off: there is no alarm</source>
            <translation>Отвести: аварии нет</translation>
        </message>
        <message>
            <source>Back the axis off its sensor, reset the alarm, then home; check the wire if no axis stands at a sensor.</source>
            <translation>Отведите ось от датчика, сбросьте аварию, затем найдите нули; если у датчика нет ни одной оси, проверьте провод.</translation>
        </message>
        <message>
            <source>Back to the machine</source>
            <translation>Назад к станку</translation>
        </message>
        <message>
            <source>Between entries</source>
            <translation>Между записями</translation>
        </message>
        <message>
            <source>Between two points the path may leave the straight line by this.</source>
            <translation>Между двумя точками путь может отойти от прямой на столько.</translation>
        </message>
        <message>
            <source>Both heads in</source>
            <translation>Обе головки внутрь</translation>
        </message>
        <message>
            <source>Both heads out</source>
            <translation>Обе головки наружу</translation>
        </message>
        <message>
            <source>By feed and top speeds alone; the core plans it when it is published</source>
            <translation>Только по подаче и предельным скоростям; ядро спланирует задание, когда оно будет опубликовано</translation>
        </message>
        <message>
            <source>By hand</source>
            <translation>Вручную</translation>
        </message>
        <message>
            <source>CARVING</source>
            <translation>РЕЗЬБА</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Отмена</translation>
        </message>
        <message>
            <source>Cancel reading</source>
            <translation>Прервать чтение</translation>
        </message>
        <message>
            <source>Carved against wanted: blue too deep, brown material left</source>
            <translation>Вырезанное против заданного: синее — слишком глубоко, коричневое — остался материал</translation>
        </message>
        <message>
            <source>Carved piece</source>
            <translation>Деталь</translation>
        </message>
        <message>
            <source>Carves this layer and stops in order; press again for the next one</source>
            <translation>Вырезает этот слой и останавливается; нажмите ещё раз для следующего</translation>
        </message>
        <message>
            <source>Carving</source>
            <translation>Резьба</translation>
        </message>
        <message>
            <source>Carving time</source>
            <translation>Время резьбы</translation>
        </message>
        <message>
            <source>Check the axis' home sensor, its wire and its pin in the profile; reset the alarm, then home again.</source>
            <translation>Проверьте датчик нуля оси, его провод и вывод в профиле; сбросьте аварию, затем снова найдите нули.</translation>
        </message>
        <message>
            <source>Check the port's cable, device and permissions; reset the alarm, then home.</source>
            <translation>Проверьте кабель порта, устройство и права; сбросьте аварию, затем найдите нули.</translation>
        </message>
        <message>
            <source>Check the sensor of axis %1</source>
            <translation>Проверьте датчик оси %1</translation>
        </message>
        <message>
            <source>Clear switch %1, or Back off, until its lamp goes out</source>
            <translation>Освободите выключатель %1 или нажмите «Отвести», пока его лампа не погаснет</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Закрыть</translation>
        </message>
        <message>
            <source>Close other programs, or give the core real-time rights</source>
            <translation>Закройте другие программы или дайте ядру права реального времени</translation>
        </message>
        <message>
            <source>Close the window</source>
            <translation>Закрыть окно</translation>
        </message>
        <message>
            <source>Command: %1</source>
            <translation>Команда: %1</translation>
        </message>
        <message>
            <source>Compare with defaults</source>
            <translation>Сравнить с исходным</translation>
        </message>
        <message>
            <source>Controlled stop above this many missed ticks a second; 0: never.</source>
            <translation>Управляемая остановка, если за секунду пропущено больше тактов; 0: никогда.</translation>
        </message>
        <message>
            <source>Core alive</source>
            <translation>Ядро работает</translation>
        </message>
        <message>
            <source>Core found, process %1</source>
            <translation>Ядро найдено, процесс %1</translation>
        </message>
        <message>
            <source>Dark</source>
            <translation>Тёмная</translation>
        </message>
        <message>
            <source>Deviation</source>
            <translation>Отклонение</translation>
        </message>
        <message>
            <source>Deviation: not of a recording; psicarve verify tells it</source>
            <translation>Отклонение: не для записи; его назовёт psicarve verify</translation>
        </message>
        <message>
            <source>Direction of R2 minus 180 degrees, measured once.</source>
            <translation>Направление R2 минус 180 градусов, измеряется однажды.</translation>
        </message>
        <message>
            <source>Direction stands at least this long after a step's edge.</source>
            <translation>Направление держится после фронта шага не меньше.</translation>
        </message>
        <message>
            <source>Direction stands at least this long before a step's edge.</source>
            <translation>Направление установлено до фронта шага не меньше.</translation>
        </message>
        <message>
            <source>Disarm</source>
            <translation>Выключить</translation>
        </message>
        <message>
            <source>Disarm keyboard jog</source>
            <translation>Выключить клавиши</translation>
        </message>
        <message>
            <source>Done</source>
            <translation>Готовое</translation>
        </message>
        <message>
            <source>Drives and spindle are off. No axis moved: home only if one was turned by hand.</source>
            <translation>Приводы и шпиндель выключены. Ни одна ось не двигалась: нули нужны, только если ось повернули рукой.</translation>
        </message>
        <message>
            <source>Drives and spindle are off; the position is not certain any more.</source>
            <translation>Приводы и шпиндель выключены; положение больше не достоверно.</translation>
        </message>
        <message>
            <source>Drives and spindle on</source>
            <translation>Приводы и шпиндель включены</translation>
        </message>
        <message>
            <source>Drives are off</source>
            <translation>Приводы выключены</translation>
        </message>
        <message>
            <source>Drives off</source>
            <translation>Отключить приводы</translation>
        </message>
        <message>
            <source>Drives off, not homed</source>
            <translation>Выключен, нулей нет</translation>
        </message>
        <message>
            <source>Drives off: they are off</source>
            <translation>Отключить приводы: они отключены</translation>
        </message>
        <message>
            <source>Drives on, spindle off</source>
            <translation>Приводы включены, шпиндель выключен</translation>
        </message>
        <message>
            <source>Drives switched off</source>
            <translation>Приводы выключены</translation>
        </message>
        <message>
            <source>Drives switched on</source>
            <translation>Приводы включены</translation>
        </message>
        <message>
            <source>EMERGENCY STOP</source>
            <translation>АВАРИЙНЫЙ
ОСТАНОВ (F1)</translation>
        </message>
        <message>
            <source>Emergency stop</source>
            <translation>Аварийный останов</translation>
        </message>
        <message>
            <source>Emergency stop asked for</source>
            <translation>Запрошен аварийный останов</translation>
        </message>
        <message>
            <source>Emergency stop switch pressed</source>
            <translation>Нажат аварийный выключатель</translation>
        </message>
        <message>
            <source>Emergency stop switch released</source>
            <translation>Аварийный выключатель отпущен</translation>
        </message>
        <message>
            <source>End</source>
            <translation>Конец</translation>
        </message>
        <message>
            <source>End at which the limit sensor stands.</source>
            <translation>Конец, на котором стоит концевой датчик.</translation>
        </message>
        <message>
            <source>Entries of the recording</source>
            <translation>Записи журнала</translation>
        </message>
        <message>
            <source>Entry of kind %1</source>
            <translation>Запись вида %1</translation>
        </message>
        <message>
            <source>Every pulse</source>
            <translation>Импульсы</translation>
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
            <translation>F1  аварийный останов, везде
Esc  стоп, везде, пока станок работает
Ctrl+Enter  пуск
Pause  пауза, продолжить
Ctrl+Home  поиск нуля всех осей
Ctrl+0, Ctrl+−, Ctrl++  коррекция подачи
Ctrl+O  открыть
F5  нарезать
F9  включить перемещение с клавиатуры
Ctrl+1 … 7  вкладки
Ctrl+L  номер слоя
F6  следующая панель
F10  меню
F12  этот список

Воспроизведение: K  пуск, пауза
J, L  медленнее, быстрее
N, Shift+N  следующая, предыдущая запись
,  .  один слой
На шкале времени: стрелки, Page Up, Page Down, Home, End</translation>
        </message>
        <message>
            <source>F1 · the live machine</source>
            <translation>F1 · живой станок</translation>
        </message>
        <message>
            <source>F1 · works everywhere</source>
            <translation>F1 · действует везде</translation>
        </message>
        <message>
            <source>FINISHING</source>
            <translation>ЗАВЕРШЕНИЕ</translation>
        </message>
        <message>
            <source>Feed override</source>
            <translation>Коррекция подачи</translation>
        </message>
        <message>
            <source>Feed override %1 %</source>
            <translation>Коррекция подачи %1 %</translation>
        </message>
        <message>
            <source>Feed override %1 % → %2 %</source>
            <translation>Коррекция подачи %1 % → %2 %</translation>
        </message>
        <message>
            <source>Feed override: reset the alarm first</source>
            <translation>Коррекция подачи: сначала сбросьте аварию</translation>
        </message>
        <message>
            <source>Feed override: the machine is not homed</source>
            <translation>Коррекция подачи: нули не найдены</translation>
        </message>
        <message>
            <source>Find a key</source>
            <translation>Найти ключ</translation>
        </message>
        <message>
            <source>Fit</source>
            <translation>Вписать</translation>
        </message>
        <message>
            <source>Flight recorder</source>
            <translation>Самописец</translation>
        </message>
        <message>
            <source>Folder for the support bundle</source>
            <translation>Папка для пакета поддержки</translation>
        </message>
        <message>
            <source>Forgets the zero of %1</source>
            <translation>Забывает отсчёт %1</translation>
        </message>
        <message>
            <source>From layer</source>
            <translation>Со слоя</translation>
        </message>
        <message>
            <source>From layer %1</source>
            <translation>Со слоя %1</translation>
        </message>
        <message>
            <source>From the flight recorder. A click goes to an entry.</source>
            <translation>Из самописца. Щелчок ведёт к записи.</translation>
        </message>
        <message>
            <source>From your zero of %1. The large number is the machine's own position.</source>
            <translation>От вашего отсчёта %1. Крупное число — положение самого станка.</translation>
        </message>
        <message>
            <source>Front</source>
            <translation>Спереди</translation>
        </message>
        <message>
            <source>General</source>
            <translation>Общее</translation>
        </message>
        <message>
            <source>Gives the job to the core, which checks it</source>
            <translation>Передаёт задание ядру, которое его проверит</translation>
        </message>
        <message>
            <source>Greatest difference at an index pass that is not the alarm steps lost.</source>
            <translation>Наибольшее расхождение на проходе нуля, ещё не вызывающее аварию «потеря шагов».</translation>
        </message>
        <message>
            <source>HELD</source>
            <translation>ПАУЗА</translation>
        </message>
        <message>
            <source>HOLDING</source>
            <translation>ОСТАНОВКА НА ПАУЗУ</translation>
        </message>
        <message>
            <source>HOMING</source>
            <translation>ПОИСК НУЛЯ</translation>
        </message>
        <message>
            <source>Head R2</source>
            <translation>Головка R2</translation>
        </message>
        <message>
            <source>Heads move out this far after the last point and on stop.</source>
            <translation>На столько головки отходят после последней точки и при остановке.</translation>
        </message>
        <message>
            <source>Heads out, spindle off</source>
            <translation>Головки отходят, шпиндель выключается</translation>
        </message>
        <message>
            <source>Heads to the first point, then carve (Ctrl+Enter)</source>
            <translation>Головки к первой точке, затем резьба (Ctrl+Enter)</translation>
        </message>
        <message>
            <source>Height</source>
            <translation>Высота</translation>
        </message>
        <message>
            <source>Height, radius</source>
            <translation>Высота, радиус</translation>
        </message>
        <message>
            <source>Hold</source>
            <translation>Пауза</translation>
        </message>
        <message>
            <source>Hold = move, click = one step.</source>
            <translation>Удерживать = двигаться, щелчок = один шаг.</translation>
        </message>
        <message>
            <source>Hold for high</source>
            <translation>Держать: высокий</translation>
        </message>
        <message>
            <source>Hold, Resume, Stop: nothing is moving.</source>
            <translation>Пауза, Продолжить, Стоп: ничего не движется.</translation>
        </message>
        <message>
            <source>Hold: nothing is carved</source>
            <translation>Пауза: резьба не идёт</translation>
        </message>
        <message>
            <source>Hold: on hold already</source>
            <translation>Пауза: уже на паузе</translation>
        </message>
        <message>
            <source>Home</source>
            <translation>Поиск нуля</translation>
        </message>
        <message>
            <source>Home %1</source>
            <translation>Ноль %1</translation>
        </message>
        <message>
            <source>Home all</source>
            <translation>Все нули</translation>
        </message>
        <message>
            <source>Home Ψ: home R1 and R2 first</source>
            <translation>Ноль Ψ: сначала найдите нули R1 и R2</translation>
        </message>
        <message>
            <source>Homed, job published</source>
            <translation>Нули найдены, задание передано</translation>
        </message>
        <message>
            <source>Homed, no job</source>
            <translation>Нули найдены, задания нет</translation>
        </message>
        <message>
            <source>Homing of axis %1 failed</source>
            <translation>Поиск нуля оси %1 не удался</translation>
        </message>
        <message>
            <source>Homing: positions defined</source>
            <translation>Поиск нуля: положения заданы</translation>
        </message>
        <message>
            <source>How far past the sensor the mechanics allow.</source>
            <translation>На сколько механика допускает ход за датчик.</translation>
        </message>
        <message>
            <source>How late ticks were: number of ticks by lateness</source>
            <translation>Насколько запаздывали такты: число тактов по запаздыванию</translation>
        </message>
        <message>
            <source>How many pulses</source>
            <translation>Сколько импульсов</translation>
        </message>
        <message>
            <source>How much higher R2 stands than R1, measured once.</source>
            <translation>На сколько R2 стоит выше R1, измеряется однажды.</translation>
        </message>
        <message>
            <source>IDLE</source>
            <translation>ОЖИДАНИЕ</translation>
        </message>
        <message>
            <source>In the file: %1</source>
            <translation>В файле: %1</translation>
        </message>
        <message>
            <source>In the recording</source>
            <translation>Что записано</translation>
        </message>
        <message>
            <source>Info</source>
            <translation>Сведения</translation>
        </message>
        <message>
            <source>Input pin 10..13 or 15; 0: not wired; minus: active low.</source>
            <translation>Вход: вывод 10..13 или 15; 0: не подключён; минус: активный низкий.</translation>
        </message>
        <message>
            <source>Inputs active: %1</source>
            <translation>Входы активны: %1</translation>
        </message>
        <message>
            <source>Inputs: none active</source>
            <translation>Входы: ни один не активен</translation>
        </message>
        <message>
            <source>Iso</source>
            <translation>Изометрия</translation>
        </message>
        <message>
            <source>Its sensor was not found, or did not clear. Likely a broken wire or a sensor out of place.</source>
            <translation>Датчик не найден или не отпустил. Вероятно, обрыв провода или датчик сдвинут.</translation>
        </message>
        <message>
            <source>JSON (*.json)</source>
            <translation>JSON (*.json)</translation>
        </message>
        <message>
            <source>Job</source>
            <translation>Задание</translation>
        </message>
        <message>
            <source>Job in travel</source>
            <translation>Ход достаточен</translation>
        </message>
        <message>
            <source>Job no. %1 accepted</source>
            <translation>Задание № %1 принято</translation>
        </message>
        <message>
            <source>Job or snapshot of this trace</source>
            <translation>Задание или снимок этой трассы</translation>
        </message>
        <message>
            <source>Job published</source>
            <translation>Передано</translation>
        </message>
        <message>
            <source>Job: %1 × %2 points</source>
            <translation>Задание: %1 × %2 точек</translation>
        </message>
        <message>
            <source>Jobs and snapshots (*.job *.psi *.snap);;All files (*)</source>
            <translation>Задания и снимки (*.job *.psi *.snap);;Все файлы (*)</translation>
        </message>
        <message>
            <source>Jog</source>
            <translation>Ручное перемещение</translation>
        </message>
        <message>
            <source>Jog ends</source>
            <translation>Ручное перемещение кончается</translation>
        </message>
        <message>
            <source>Jog speed of R1, R2 and Y</source>
            <translation>Скорость ручного перемещения R1, R2 и Y</translation>
        </message>
        <message>
            <source>Jog speed of Ψ</source>
            <translation>Скорость ручного перемещения Ψ</translation>
        </message>
        <message>
            <source>Jog: the machine is not homed</source>
            <translation>Ручное перемещение: нули не найдены</translation>
        </message>
        <message>
            <source>Joining</source>
            <translation>Связь слоёв</translation>
        </message>
        <message>
            <source>Keys</source>
            <translation>Клавиши</translation>
        </message>
        <message>
            <source>Keys…</source>
            <translation>Клавиши…</translation>
        </message>
        <message>
            <source>Kind</source>
            <translation>Вид</translation>
        </message>
        <message>
            <source>Language</source>
            <translation>Язык</translation>
        </message>
        <message>
            <source>Late: median, 99 %, 99.9 %</source>
            <translation>Медиана, 99 %, 99.9 %</translation>
        </message>
        <message>
            <source>Latest of all</source>
            <translation>Наибольшее</translation>
        </message>
        <message>
            <source>Layer</source>
            <translation>Слой</translation>
        </message>
        <message>
            <source>Layer %1</source>
            <translation>Слой %1</translation>
        </message>
        <message>
            <source>Layer %1 / %2, point %3 / %4</source>
            <translation>Слой %1 / %2, точка %3 / %4</translation>
        </message>
        <message>
            <source>Layer %1 of %2</source>
            <translation>Слой %1 из %2</translation>
        </message>
        <message>
            <source>Layer to start from</source>
            <translation>Слой, с которого начать</translation>
        </message>
        <message>
            <source>Layers</source>
            <translation>Слои</translation>
        </message>
        <message>
            <source>Layers × points</source>
            <translation>Слои × точки</translation>
        </message>
        <message>
            <source>Least distance between the two tool tips.</source>
            <translation>Наименьшее расстояние между остриями инструментов.</translation>
        </message>
        <message>
            <source>Leave replay</source>
            <translation>Закрыть запись</translation>
        </message>
        <message>
            <source>Leave running</source>
            <translation>Пусть работает</translation>
        </message>
        <message>
            <source>Leaves out the layers before it</source>
            <translation>Пропускает слои до него</translation>
        </message>
        <message>
            <source>Leaves replay and opens the job in this snapshot</source>
            <translation>Закрывает воспроизведение и открывает задание из снимка</translation>
        </message>
        <message>
            <source>Level</source>
            <translation>Уровень</translation>
        </message>
        <message>
            <source>Level of the direction pin that means positive.</source>
            <translation>Уровень вывода направления, означающий плюс.</translation>
        </message>
        <message>
            <source>Levels of all pins in the last 20 seconds</source>
            <translation>Уровни всех выводов за последние 20 секунд</translation>
        </message>
        <message>
            <source>Light</source>
            <translation>Светлая</translation>
        </message>
        <message>
            <source>Light: carved (%1 layers not seen: as planned). Dark: blank.</source>
            <translation>Светлое: вырезано (слоёв не видели, показаны по плану: %1). Тёмное: заготовка.</translation>
        </message>
        <message>
            <source>Light: carved, as planned. Dark: blank.</source>
            <translation>Светлое: вырезано, по плану. Тёмное: заготовка.</translation>
        </message>
        <message>
            <source>Light: carved. Dark: blank.</source>
            <translation>Светлое: вырезано. Тёмное: заготовка.</translation>
        </message>
        <message>
            <source>Limit switch %1</source>
            <translation>Концевой выключатель %1</translation>
        </message>
        <message>
            <source>Limit switch %1 closed</source>
            <translation>Концевой выключатель %1 замкнут</translation>
        </message>
        <message>
            <source>Limit switch %1 closed (inner end, pin %2)</source>
            <translation>Концевой выключатель %1 замкнут (внутренний конец, вывод %2)</translation>
        </message>
        <message>
            <source>Limit switch %1 closed (outer end, pin %2)</source>
            <translation>Концевой выключатель %1 замкнут (внешний конец, вывод %2)</translation>
        </message>
        <message>
            <source>Limit switch %1 open</source>
            <translation>Концевой выключатель %1 разомкнут</translation>
        </message>
        <message>
            <source>Limit switch Y closed (lower end, pin %1)</source>
            <translation>Концевой выключатель Y замкнут (нижний конец, вывод %1)</translation>
        </message>
        <message>
            <source>Limit switch Y closed (upper end, pin %1)</source>
            <translation>Концевой выключатель Y замкнут (верхний конец, вывод %1)</translation>
        </message>
        <message>
            <source>Limits clear</source>
            <translation>Концевики</translation>
        </message>
        <message>
            <source>Live machine: %1</source>
            <translation>Станок: %1</translation>
        </message>
        <message>
            <source>Locked by the wiring test</source>
            <translation>Заперто: проверка проводки</translation>
        </message>
        <message>
            <source>Locked on hold: resume or stop</source>
            <translation>На паузе заперто: продолжите или остановите</translation>
        </message>
        <message>
            <source>Locked until the alarm is reset</source>
            <translation>Заперто до сброса аварии</translation>
        </message>
        <message>
            <source>Locked while an axis moves</source>
            <translation>Заперто, пока движется ось</translation>
        </message>
        <message>
            <source>Locked while carving</source>
            <translation>Заперто во время резьбы</translation>
        </message>
        <message>
            <source>Locked while the machine homes</source>
            <translation>Заперто во время поиска нулей</translation>
        </message>
        <message>
            <source>Locked while the machine stops</source>
            <translation>Заперто во время остановки</translation>
        </message>
        <message>
            <source>Locked: the heads wait at the first point; start or stop</source>
            <translation>Заперто: головки ждут у первой точки; пуск или стоп</translation>
        </message>
        <message>
            <source>Log saved: %1</source>
            <translation>Журнал сохранён: %1</translation>
        </message>
        <message>
            <source>Logical levels, looked at 30 times a second; steps by how many there were in between. A trace (--trace) holds every edge.</source>
            <translation>Логические уровни, 30 взглядов в секунду; шаги показаны числом между взглядами. Каждый фронт есть в записи (--trace).</translation>
        </message>
        <message>
            <source>Look for what held the table back and lower its speed or acceleration if nothing did; reset the alarm, then home.</source>
            <translation>Найдите, что задержало стол; если ничего, снизьте его скорость или ускорение; сбросьте аварию, затем найдите нули.</translation>
        </message>
        <message>
            <source>Look for what holds the table</source>
            <translation>Найдите, что держит стол</translation>
        </message>
        <message>
            <source>Looking for the sensors</source>
            <translation>Идёт поиск датчиков</translation>
        </message>
        <message>
            <source>Lowest and highest position.</source>
            <translation>Наименьшее и наибольшее положение.</translation>
        </message>
        <message>
            <source>Lowest point of the model above the table; baked into a job's heights.</source>
            <translation>Нижняя точка модели над столом; входит в высоты задания.</translation>
        </message>
        <message>
            <source>MOVING</source>
            <translation>ДВИЖЕНИЕ</translation>
        </message>
        <message>
            <source>Machine profile</source>
            <translation>Профиль станка</translation>
        </message>
        <message>
            <source>Machine: %1</source>
            <translation>Станок: %1</translation>
        </message>
        <message>
            <source>Makes the job's tables (F5)</source>
            <translation>Составляет таблицы задания (F5)</translation>
        </message>
        <message>
            <source>Menu</source>
            <translation>Меню</translation>
        </message>
        <message>
            <source>Menu (F10)</source>
            <translation>Меню (F10)</translation>
        </message>
        <message>
            <source>Messages</source>
            <translation>Сообщения</translation>
        </message>
        <message>
            <source>Missed ticks</source>
            <translation>Пропущено тактов</translation>
        </message>
        <message>
            <source>Missed, skipped</source>
            <translation>Пропущено</translation>
        </message>
        <message>
            <source>Model</source>
            <translation>Модель</translation>
        </message>
        <message>
            <source>Models and jobs (*.stl *.obj *.ply *.3mf *.off *.job *.psi);;Recordings (*.snap *.trace);;All files (*)</source>
            <translation>Модели и задания (*.stl *.obj *.ply *.3mf *.off *.job *.psi);;Записи (*.snap *.trace);;Все файлы (*)</translation>
        </message>
        <message>
            <source>Motor pulses for one millimetre.</source>
            <translation>Импульсов двигателя на миллиметр.</translation>
        </message>
        <message>
            <source>Motor pulses for one turn of the table; even.</source>
            <translation>Импульсов двигателя на оборот стола; чётное число.</translation>
        </message>
        <message>
            <source>Moves the axis away from its closed switch, slowly</source>
            <translation>Медленно отводит ось от замкнутого выключателя</translation>
        </message>
        <message>
            <source>NO CORE</source>
            <translation>НЕТ ЯДРА</translation>
        </message>
        <message>
            <source>Name of the machine, for people.</source>
            <translation>Название станка, для людей.</translation>
        </message>
        <message>
            <source>No alarm</source>
            <translation>Аварии нет</translation>
        </message>
        <message>
            <source>No core has been seen yet</source>
            <translation>Ядра ещё не было видно</translation>
        </message>
        <message>
            <source>No core serves the segment</source>
            <translation>Сегмент не обслуживает ни одно ядро</translation>
        </message>
        <message>
            <source>No core: these are the last figures known</source>
            <translation>Нет ядра: это последние известные значения</translation>
        </message>
        <message>
            <source>No core: these are the last levels known.</source>
            <translation>Нет ядра: это последние известные уровни.</translation>
        </message>
        <message>
            <source>No core: use the switch on the machine</source>
            <translation>Нет ядра: нажмите кнопку на станке</translation>
        </message>
        <message>
            <source>No job</source>
            <translation>Нет задания</translation>
        </message>
        <message>
            <source>No job is published.</source>
            <translation>Задание не передано.</translation>
        </message>
        <message>
            <source>No job: slice a model or open a job</source>
            <translation>Нет задания: нарежьте модель или откройте задание</translation>
        </message>
        <message>
            <source>No key has these letters</source>
            <translation>Нет ключа с этими буквами</translation>
        </message>
        <message>
            <source>No model. Open one from the menu, or drop a file here.</source>
            <translation>Модели нет. Откройте её из меню или перетащите файл сюда.</translation>
        </message>
        <message>
            <source>No tick by a real clock so far</source>
            <translation>Тактов по настоящим часам ещё не было</translation>
        </message>
        <message>
            <source>No tick missed in the last second; %1 before</source>
            <translation>За последнюю секунду тактов не пропущено; раньше: %1</translation>
        </message>
        <message>
            <source>No tick missed since the core started</source>
            <translation>С запуска ядра тактов не пропущено</translation>
        </message>
        <message>
            <source>No zero</source>
            <translation>Снять Δ</translation>
        </message>
        <message>
            <source>None yet</source>
            <translation>Пока нет</translation>
        </message>
        <message>
            <source>Not homed, job published</source>
            <translation>Нули не найдены, задание передано</translation>
        </message>
        <message>
            <source>Not saved: %1</source>
            <translation>Не сохранено: %1</translation>
        </message>
        <message>
            <source>Not sliced yet.</source>
            <translation>Ещё не нарезано.</translation>
        </message>
        <message>
            <source>Nothing differs from the built-in profile</source>
            <translation>Отличий от встроенного профиля нет</translation>
        </message>
        <message>
            <source>Nothing is carved closer to the axis.</source>
            <translation>Ближе к оси ничего не вырезается.</translation>
        </message>
        <message>
            <source>Nothing is open.</source>
            <translation>Ничего не открыто.</translation>
        </message>
        <message>
            <source>Nothing is wrong.</source>
            <translation>Всё в порядке.</translation>
        </message>
        <message>
            <source>Of top speed</source>
            <translation>От предела</translation>
        </message>
        <message>
            <source>One layer</source>
            <translation>Один слой</translation>
        </message>
        <message>
            <source>One output by hand</source>
            <translation>Один выход вручную</translation>
        </message>
        <message>
            <source>One timer for everything, or the original's two.</source>
            <translation>Один таймер на всё или два, как у прежней машины.</translation>
        </message>
        <message>
            <source>Open a machine profile</source>
            <translation>Открыть профиль станка</translation>
        </message>
        <message>
            <source>Open its job</source>
            <translation>Открыть задание</translation>
        </message>
        <message>
            <source>Open model, job or recording</source>
            <translation>Открыть модель, задание или запись</translation>
        </message>
        <message>
            <source>Open model, job or recording…</source>
            <translation>Открыть модель, задание или запись…</translation>
        </message>
        <message>
            <source>Open recent</source>
            <translation>Недавние</translation>
        </message>
        <message>
            <source>Open...</source>
            <translation>Открыть...</translation>
        </message>
        <message>
            <source>Open: a job is being made; cancel it first</source>
            <translation>Открыть: задание составляется; сначала отмените</translation>
        </message>
        <message>
            <source>OpenGL took the window down the last time: drawing without it</source>
            <translation>В прошлый раз OpenGL обрушил окно: рисуем без него</translation>
        </message>
        <message>
            <source>Opened %1</source>
            <translation>Открыт %1</translation>
        </message>
        <message>
            <source>Opened, not sliced yet: %1</source>
            <translation>Открыто, ещё не нарезано: %1</translation>
        </message>
        <message>
            <source>Output pin 1..9, 14, 16 or 17; 0: not wired; minus: active low.</source>
            <translation>Выход: вывод 1..9, 14, 16 или 17; 0: не подключён; минус: активный низкий.</translation>
        </message>
        <message>
            <source>Output to test</source>
            <translation>Проверяемый выход</translation>
        </message>
        <message>
            <source>POSITIONING</source>
            <translation>ПОДВОД</translation>
        </message>
        <message>
            <source>Part of the next command</source>
            <translation>Часть следующей команды</translation>
        </message>
        <message>
            <source>Parts of the profile</source>
            <translation>Части профиля</translation>
        </message>
        <message>
            <source>Pause</source>
            <translation>Пауза</translation>
        </message>
        <message>
            <source>Period of the core's base tick; pins change only at ticks.</source>
            <translation>Период основного такта ядра; выводы меняются только в такты.</translation>
        </message>
        <message>
            <source>Pin</source>
            <translation>Вывод</translation>
        </message>
        <message>
            <source>Placement and slicing</source>
            <translation>Положение и нарезка</translation>
        </message>
        <message>
            <source>Planner angle: directions that differ by less belong to one segment.</source>
            <translation>planner angle: направления с меньшей разницей — один участок.</translation>
        </message>
        <message>
            <source>Planning fell behind the motion: free the computer of other work or lower the feed; reset the alarm, then start again.</source>
            <translation>Расчёт отстал от движения: освободите компьютер от другой работы или снизьте подачу; сбросьте аварию, затем пустите снова.</translation>
        </message>
        <message>
            <source>Play</source>
            <translation>Пуск</translation>
        </message>
        <message>
            <source>Play or pause (K)</source>
            <translation>Пуск или пауза (K)</translation>
        </message>
        <message>
            <source>Play that a reversal takes up before the axis moves.</source>
            <translation>Люфт, выбираемый при смене направления, прежде чем ось пойдёт.</translation>
        </message>
        <message>
            <source>Play that a reversal takes up before the table turns.</source>
            <translation>Люфт, выбираемый при смене направления, прежде чем стол повернётся.</translation>
        </message>
        <message>
            <source>Points / head</source>
            <translation>Точек на головку</translation>
        </message>
        <message>
            <source>Port pins</source>
            <translation>Выводы порта</translation>
        </message>
        <message>
            <source>Port timing</source>
            <translation>Времена порта</translation>
        </message>
        <message>
            <source>Ports</source>
            <translation>Порт</translation>
        </message>
        <message>
            <source>Position</source>
            <translation>Положение</translation>
        </message>
        <message>
            <source>Position at the index.</source>
            <translation>Положение у датчика нуля.</translation>
        </message>
        <message>
            <source>Position at the sensor's edge.</source>
            <translation>Положение у края датчика.</translation>
        </message>
        <message>
            <source>Positioning keeps the heads this far outside the blank.</source>
            <translation>При подводе головки держатся на столько вне заготовки.</translation>
        </message>
        <message>
            <source>Positions are lost; home again afterwards</source>
            <translation>Положения теряются; затем снова найдите нули</translation>
        </message>
        <message>
            <source>Pre-flight</source>
            <translation>Перед пуском</translation>
        </message>
        <message>
            <source>Profile</source>
            <translation>Профиль</translation>
        </message>
        <message>
            <source>Profile not saved: %1</source>
            <translation>Профиль не сохранён: %1</translation>
        </message>
        <message>
            <source>Profile saved: %1</source>
            <translation>Профиль сохранён: %1</translation>
        </message>
        <message>
            <source>Profile, log, snapshot of job and status, versions: for whoever helps</source>
            <translation>Профиль, журнал, снимок задания и состояния, версии: для того, кто поможет</translation>
        </message>
        <message>
            <source>Profiles (*.toml)</source>
            <translation>Профили (*.toml)</translation>
        </message>
        <message>
            <source>Progress</source>
            <translation>Ход работы</translation>
        </message>
        <message>
            <source>Publish</source>
            <translation>Передать</translation>
        </message>
        <message>
            <source>Publish: a job is being made</source>
            <translation>Передать: задание составляется</translation>
        </message>
        <message>
            <source>Publish: the machine is busy</source>
            <translation>Передать: станок занят</translation>
        </message>
        <message>
            <source>Publish: there is no job; slice the model first</source>
            <translation>Передать: задания нет; сначала нарежьте модель</translation>
        </message>
        <message>
            <source>Publish: this job is published</source>
            <translation>Передать: это задание уже передано</translation>
        </message>
        <message>
            <source>Publishing …</source>
            <translation>Передаётся …</translation>
        </message>
        <message>
            <source>Pull-in speed: what the motor may jump to from rest (j_k).</source>
            <translation>Скорость приёмистости: на неё двигатель может перейти сразу из покоя (j_k).</translation>
        </message>
        <message>
            <source>Pulses in a second</source>
            <translation>Импульсов в секунду</translation>
        </message>
        <message>
            <source>Pulses of %1</source>
            <translation>Импульсы %1</translation>
        </message>
        <message>
            <source>Pulses of the job</source>
            <translation>Импульсы задания</translation>
        </message>
        <message>
            <source>Pulses per second R1, R2, Ψ, Y</source>
            <translation>Импульсов в секунду R1, R2, Ψ, Y</translation>
        </message>
        <message>
            <source>R1 and R2 out, then Y, then Ψ to its index (Ctrl+Home)</source>
            <translation>R1 и R2 наружу, затем Y, затем Ψ к нулю (Ctrl+Home)</translation>
        </message>
        <message>
            <source>R1 direction</source>
            <translation>R1 направление</translation>
        </message>
        <message>
            <source>R1 enable</source>
            <translation>R1 включение</translation>
        </message>
        <message>
            <source>R1 in</source>
            <translation>R1
внутрь</translation>
        </message>
        <message>
            <source>R1 limit</source>
            <translation>R1 концевик</translation>
        </message>
        <message>
            <source>R1 out</source>
            <translation>R1
наружу</translation>
        </message>
        <message>
            <source>R1 step</source>
            <translation>R1 шаг</translation>
        </message>
        <message>
            <source>R2 direction</source>
            <translation>R2 направление</translation>
        </message>
        <message>
            <source>R2 enable</source>
            <translation>R2 включение</translation>
        </message>
        <message>
            <source>R2 in</source>
            <translation>R2
внутрь</translation>
        </message>
        <message>
            <source>R2 limit</source>
            <translation>R2 концевик</translation>
        </message>
        <message>
            <source>R2 out</source>
            <translation>R2
наружу</translation>
        </message>
        <message>
            <source>R2 step</source>
            <translation>R2 шаг</translation>
        </message>
        <message>
            <source>READY</source>
            <translation>ГОТОВ</translation>
        </message>
        <message>
            <source>REPLAY</source>
            <translation>ЗАПИСЬ</translation>
        </message>
        <message>
            <source>REPLAY: %1</source>
            <translation>ЗАПИСЬ: %1</translation>
        </message>
        <message>
            <source>Radii of all layers, unrolled</source>
            <translation>Радиусы всех слоёв, развёртка</translation>
        </message>
        <message>
            <source>Radius</source>
            <translation>Радиус</translation>
        </message>
        <message>
            <source>Read off the pins: a trace has no flight recorder. A click goes to an entry.</source>
            <translation>Прочитано с выводов: в трассе нет самописца. Щелчок ведёт к записи.</translation>
        </message>
        <message>
            <source>Reading the file …</source>
            <translation>Читается файл …</translation>
        </message>
        <message>
            <source>Reading the recording</source>
            <translation>Чтение записи</translation>
        </message>
        <message>
            <source>Real time</source>
            <translation>Реальное время</translation>
        </message>
        <message>
            <source>Real-time rights</source>
            <translation>Права РВ</translation>
        </message>
        <message>
            <source>Recorded levels at the entries of the flight recorder. Steps are not in a snapshot.</source>
            <translation>Уровни при записях самописца. Шагов в снимке нет.</translation>
        </message>
        <message>
            <source>Recorded levels of the 20 seconds before this moment.</source>
            <translation>Записанные уровни за 20 секунд до этого мгновения.</translation>
        </message>
        <message>
            <source>Reference time (T_ref)</source>
            <translation>Опорное время (T_ref)</translation>
        </message>
        <message>
            <source>Refused: %1</source>
            <translation>Отказано: %1</translation>
        </message>
        <message>
            <source>Register bit</source>
            <translation>Бит регистра</translation>
        </message>
        <message>
            <source>Release the emergency stop once the machine is safe, reset the alarm, then home.</source>
            <translation>Отпустите аварийный останов, когда станок безопасен, сбросьте аварию, затем найдите нули.</translation>
        </message>
        <message>
            <source>Release the emergency stop switch</source>
            <translation>Отпустите кнопку аварийного останова</translation>
        </message>
        <message>
            <source>Replay moves nothing: leave replay first</source>
            <translation>Запись ничего не движет: сначала закройте её</translation>
        </message>
        <message>
            <source>Replay: %1, %2 recorded</source>
            <translation>Воспроизведение: %1, записано %2</translation>
        </message>
        <message>
            <source>Replay: the piece cannot be shown</source>
            <translation>Воспроизведение: деталь показать нельзя</translation>
        </message>
        <message>
            <source>Replay: the piece is too large to be shown to its end</source>
            <translation>Воспроизведение: деталь слишком велика, конец не показан</translation>
        </message>
        <message>
            <source>Report</source>
            <translation>Отчёт</translation>
        </message>
        <message>
            <source>Report saved: %1</source>
            <translation>Отчёт сохранён: %1</translation>
        </message>
        <message>
            <source>Report: %1</source>
            <translation>Отчёт: %1</translation>
        </message>
        <message>
            <source>Report: no job was started</source>
            <translation>Отчёт: ни одно задание не запускалось</translation>
        </message>
        <message>
            <source>Report: the job is not known</source>
            <translation>Отчёт: задание неизвестно</translation>
        </message>
        <message>
            <source>Reset alarm</source>
            <translation>Сбросить аварию</translation>
        </message>
        <message>
            <source>Reset alarm: an axis backs off its switch</source>
            <translation>Сбросить аварию: ось отходит от выключателя</translation>
        </message>
        <message>
            <source>Reset alarm: there is no alarm</source>
            <translation>Сбросить аварию: аварии нет</translation>
        </message>
        <message>
            <source>Reset the alarm, then home.</source>
            <translation>Сбросьте аварию, затем найдите нули.</translation>
        </message>
        <message>
            <source>Result</source>
            <translation>Итог</translation>
        </message>
        <message>
            <source>Resume</source>
            <translation>Продолжить</translation>
        </message>
        <message>
            <source>Resume: not on hold</source>
            <translation>Продолжить: паузы нет</translation>
        </message>
        <message>
            <source>SIMULATOR</source>
            <translation>СИМУЛЯТОР</translation>
        </message>
        <message>
            <source>STOPPING</source>
            <translation>ОСТАНАВЛИВАЕТСЯ</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>Сохранить</translation>
        </message>
        <message>
            <source>Save as JSON…</source>
            <translation>Сохранить как JSON…</translation>
        </message>
        <message>
            <source>Save as...</source>
            <translation>Сохранить как...</translation>
        </message>
        <message>
            <source>Save log…</source>
            <translation>Сохранить журнал…</translation>
        </message>
        <message>
            <source>Save the log</source>
            <translation>Сохранить журнал</translation>
        </message>
        <message>
            <source>Save the profile as</source>
            <translation>Сохранить профиль как</translation>
        </message>
        <message>
            <source>Save the report</source>
            <translation>Сохранить отчёт</translation>
        </message>
        <message>
            <source>Save: %1 values are wrong</source>
            <translation>Сохранить: неверных значений: %1</translation>
        </message>
        <message>
            <source>Save: one value is wrong</source>
            <translation>Сохранить: одно значение неверно</translation>
        </message>
        <message>
            <source>Save: the machine moves</source>
            <translation>Сохранить: станок движется</translation>
        </message>
        <message>
            <source>Schedule two-timer: period of inputs and pulses, at most one pulse in each.</source>
            <translation>Схема two-timer: период входов и импульсов, не больше импульса за период.</translation>
        </message>
        <message>
            <source>Schedule two-timer: period of the interpolation.</source>
            <translation>Схема two-timer: период интерполяции.</translation>
        </message>
        <message>
            <source>Section at Y %1 mm, radius in mm</source>
            <translation>Сечение на Y %1 mm, радиус в mm</translation>
        </message>
        <message>
            <source>Section of the layer, seen from above</source>
            <translation>Сечение слоя, вид сверху</translation>
        </message>
        <message>
            <source>Select axis %1</source>
            <translation>Выбрать ось %1</translation>
        </message>
        <message>
            <source>Send pulses</source>
            <translation>Послать импульсы</translation>
        </message>
        <message>
            <source>Show</source>
            <translation>Показать</translation>
        </message>
        <message>
            <source>Shows how far %1 is from here; no motion changes</source>
            <translation>Показывает, как далеко %1 отсюда; движения не меняются</translation>
        </message>
        <message>
            <source>Shows only what differs from the built-in profile</source>
            <translation>Показывает только отличия от встроенного профиля</translation>
        </message>
        <message>
            <source>Side</source>
            <translation>Сбоку</translation>
        </message>
        <message>
            <source>Signal</source>
            <translation>Сигнал</translation>
        </message>
        <message>
            <source>Slice</source>
            <translation>Нарезать</translation>
        </message>
        <message>
            <source>Slice: a job is being made</source>
            <translation>Нарезать: задание составляется</translation>
        </message>
        <message>
            <source>Slice: open a model first</source>
            <translation>Нарезать: сначала откройте модель</translation>
        </message>
        <message>
            <source>Slice: this is a job, and already sliced</source>
            <translation>Нарезать: это задание, оно уже нарезано</translation>
        </message>
        <message>
            <source>Sliced, not published yet: %1</source>
            <translation>Нарезано, ещё не опубликовано: %1</translation>
        </message>
        <message>
            <source>Slicing …</source>
            <translation>Нарезается …</translation>
        </message>
        <message>
            <source>Speed</source>
            <translation>Скорость</translation>
        </message>
        <message>
            <source>Speed %1 (J slower, L faster)</source>
            <translation>Скорость %1 (J медленнее, L быстрее)</translation>
        </message>
        <message>
            <source>Speed of homing and of backing off.</source>
            <translation>Скорость поиска нуля и отвода.</translation>
        </message>
        <message>
            <source>Speed of homing.</source>
            <translation>Скорость поиска нуля.</translation>
        </message>
        <message>
            <source>Spindle</source>
            <translation>Шпиндель</translation>
        </message>
        <message>
            <source>Spindle off</source>
            <translation>Шпиндель выключен</translation>
        </message>
        <message>
            <source>Spindle on</source>
            <translation>Шпиндель включён</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>Пуск</translation>
        </message>
        <message>
            <source>Start from layer %1</source>
            <translation>Пуск со слоя %1</translation>
        </message>
        <message>
            <source>Start from layer %1: the layers below are left as they are. The heads go out, Y goes to the layer, then the heads go in at plunge speed.</source>
            <translation>Пуск со слоя %1: слои ниже остаются как есть. Головки отходят, Y идёт к слою, затем головки подводятся со скоростью врезания.</translation>
        </message>
        <message>
            <source>Start it again; home before carving on</source>
            <translation>Запустите его снова; перед продолжением найдите нули</translation>
        </message>
        <message>
            <source>Start psicarve-rtcore</source>
            <translation>Запустите psicarve-rtcore</translation>
        </message>
        <message>
            <source>Start: a job is being made</source>
            <translation>Пуск: задание составляется</translation>
        </message>
        <message>
            <source>Start: already carving</source>
            <translation>Пуск: резьба уже идёт</translation>
        </message>
        <message>
            <source>Start: an output is tested</source>
            <translation>Пуск: проверяется выход</translation>
        </message>
        <message>
            <source>Start: axis %1 is not homed</source>
            <translation>Пуск: ноль оси %1 не найден</translation>
        </message>
        <message>
            <source>Start: no job is published</source>
            <translation>Пуск: задание не передано</translation>
        </message>
        <message>
            <source>Start: on hold; resume or stop</source>
            <translation>Пуск: пауза; продолжите или остановите</translation>
        </message>
        <message>
            <source>Start: reset the alarm first</source>
            <translation>Пуск: сначала сбросьте аварию</translation>
        </message>
        <message>
            <source>Start: slice the model, then publish the job</source>
            <translation>Пуск: нарежьте модель, затем передайте задание</translation>
        </message>
        <message>
            <source>Start: stopping</source>
            <translation>Пуск: идёт остановка</translation>
        </message>
        <message>
            <source>Start: the heads are on their way</source>
            <translation>Пуск: головки подводятся</translation>
        </message>
        <message>
            <source>Start: the heads are on their way out</source>
            <translation>Пуск: головки отводятся</translation>
        </message>
        <message>
            <source>Start: the job is being published</source>
            <translation>Пуск: задание передаётся</translation>
        </message>
        <message>
            <source>Start: the job is not published</source>
            <translation>Пуск: задание не передано</translation>
        </message>
        <message>
            <source>Start: the machine moves</source>
            <translation>Пуск: станок движется</translation>
        </message>
        <message>
            <source>State at the end</source>
            <translation>Состояние в конце</translation>
        </message>
        <message>
            <source>States</source>
            <translation>Состояния</translation>
        </message>
        <message>
            <source>Step %1 %2</source>
            <translation>Шаг %1 %2</translation>
        </message>
        <message>
            <source>Stop</source>
            <translation>Стоп</translation>
        </message>
        <message>
            <source>Stop asked for</source>
            <translation>Запрошен стоп</translation>
        </message>
        <message>
            <source>Stop: all axes are at rest</source>
            <translation>Стоп: все оси стоят</translation>
        </message>
        <message>
            <source>Stop: already stopping</source>
            <translation>Стоп: уже останавливается</translation>
        </message>
        <message>
            <source>Stop: nothing is moving</source>
            <translation>Стоп: ничего не движется</translation>
        </message>
        <message>
            <source>Support bundle: %1</source>
            <translation>Пакет поддержки: %1</translation>
        </message>
        <message>
            <source>Support bundle…</source>
            <translation>Пакет поддержки…</translation>
        </message>
        <message>
            <source>Switch %1 is still closed</source>
            <translation>Выключатель %1 всё ещё замкнут</translation>
        </message>
        <message>
            <source>Switches one output at a time. Home again afterwards.</source>
            <translation>Переключает по одному выходу. Затем снова найдите нули.</translation>
        </message>
        <message>
            <source>TESTING</source>
            <translation>ПРОВЕРКА</translation>
        </message>
        <message>
            <source>T_ref</source>
            <translation>T_ref</translation>
        </message>
        <message>
            <source>Take backup</source>
            <translation>Взять копию</translation>
        </message>
        <message>
            <source>Text (*.log *.txt)</source>
            <translation>Текст (*.log *.txt)</translation>
        </message>
        <message>
            <source>The blank as carved so far</source>
            <translation>Заготовка, как она вырезана сейчас</translation>
        </message>
        <message>
            <source>The built-in profile has no file: save it as one.</source>
            <translation>У встроенного профиля нет файла: сохраните его как файл.</translation>
        </message>
        <message>
            <source>The computer is too busy: give the core real-time rights, lengthen tick.period_us or raise tick.missed_alarm_per_s; then reset the alarm.</source>
            <translation>Компьютер слишком занят: дайте ядру права реального времени, увеличьте tick.period_us или tick.missed_alarm_per_s; затем сбросьте аварию.</translation>
        </message>
        <message>
            <source>The computer paused too long while an axis moved: give the core real-time rights or a quieter machine; reset the alarm, then home.</source>
            <translation>Компьютер замер слишком надолго, пока двигалась ось: дайте ядру права реального времени или более спокойную машину; сбросьте аварию, затем найдите нули.</translation>
        </message>
        <message>
            <source>The computer paused while axis %1 moved</source>
            <translation>Компьютер замер, пока двигалась ось %1</translation>
        </message>
        <message>
            <source>The computer was too busy for the machine</source>
            <translation>Компьютер был слишком занят для станка</translation>
        </message>
        <message>
            <source>The connector's pins and their levels</source>
            <translation>Выводы разъёма и их уровни</translation>
        </message>
        <message>
            <source>The core ended in the middle of its work and its guard switched drives and spindle off: start the core again, home, and carve on from the layer it was in.</source>
            <translation>Ядро завершилось во время работы, и его сторож выключил приводы и шпиндель: запустите ядро снова, выведите оси в исходное положение и продолжайте резать со слоя, на котором оно было.</translation>
        </message>
        <message>
            <source>The core found: %1</source>
            <translation>Ядро обнаружило: %1</translation>
        </message>
        <message>
            <source>The core has ended</source>
            <translation>Ядро завершилось</translation>
        </message>
        <message>
            <source>The core has ended in layer %1</source>
            <translation>Ядро завершилось в слое %1</translation>
        </message>
        <message>
            <source>The core has this job.</source>
            <translation>Это задание есть у ядра.</translation>
        </message>
        <message>
            <source>The core is silent</source>
            <translation>Ядро молчит</translation>
        </message>
        <message>
            <source>The core is silent: use the switch on the machine</source>
            <translation>Ядро молчит: нажмите кнопку на станке</translation>
        </message>
        <message>
            <source>The core runs on a virtual clock: no tick is ever late</source>
            <translation>Ядро идёт по виртуальным часам: такты не запаздывают</translation>
        </message>
        <message>
            <source>The emergency stop switch is still pressed</source>
            <translation>Кнопка аварийного останова всё ещё нажата</translation>
        </message>
        <message>
            <source>The file ends without endsolid.</source>
            <translation>Файл кончается без endsolid.</translation>
        </message>
        <message>
            <source>The gap between two step pulses lasts at least this long.</source>
            <translation>Промежуток между шаговыми импульсами длится не меньше.</translation>
        </message>
        <message>
            <source>The guard process ended: start the core again.</source>
            <translation>Сторожевой процесс завершился: запустите ядро снова.</translation>
        </message>
        <message>
            <source>The heads wait at the first point; start or stop</source>
            <translation>Головки ждут у первой точки; пуск или стоп</translation>
        </message>
        <message>
            <source>The job is ready to be published.</source>
            <translation>Задание готово к передаче.</translation>
        </message>
        <message>
            <source>The job or snapshot that this trace belongs to</source>
            <translation>Задание или снимок, к которому относится трасса</translation>
        </message>
        <message>
            <source>The language changes when the window is opened the next time</source>
            <translation>Язык сменится при следующем открытии окна</translation>
        </message>
        <message>
            <source>The least time that the motors' limits allow for the whole job</source>
            <translation>Наименьшее время всего задания, которое допускают пределы двигателей</translation>
        </message>
        <message>
            <source>The live machine, not the recording</source>
            <translation>Живой станок, не запись</translation>
        </message>
        <message>
            <source>The log is not kept: %1</source>
            <translation>Журнал не ведётся: %1</translation>
        </message>
        <message>
            <source>The machine is at work. It does not need this window: what is to become of it?</source>
            <translation>Станок работает. Это окно ему не нужно: что с ним делать?</translation>
        </message>
        <message>
            <source>The machine's profile is not known here: pins are those of the built-in profile.</source>
            <translation>Профиль станка здесь неизвестен: выводы взяты из встроенного профиля.</translation>
        </message>
        <message>
            <source>The mesh is open at %1 of the samples; what is missing there is carved down to what lies behind it, or to the core.</source>
            <translation>Сетка открыта в %1 отсчётах; недостающее там вырезается до того, что лежит за ним, или до сердцевины.</translation>
        </message>
        <message>
            <source>The model in space</source>
            <translation>Модель в пространстве</translation>
        </message>
        <message>
            <source>The model is only %1 mm high: are its units inches or metres? Height makes it larger.</source>
            <translation>Высота модели всего %1 mm: её единицы — дюймы или метры? Увеличьте её через «Высота».</translation>
        </message>
        <message>
            <source>The model stands so far from its file's origin that its coordinates are rounded to %1 mm, more than a pulse (%2 mm): move it to the origin before it is exported.</source>
            <translation>Модель стоит так далеко от начала координат файла, что её координаты округлены до %1 mm, больше импульса (%2 mm): перенесите её к началу перед экспортом.</translation>
        </message>
        <message>
            <source>The old file is kept as a backup. A core takes a profile when it starts.</source>
            <translation>Старый файл остаётся копией. Ядро берёт профиль при запуске.</translation>
        </message>
        <message>
            <source>The shared memory was removed or damaged from outside: reset the alarm and publish the job again.</source>
            <translation>Общая память удалена или повреждена извне: сбросьте аварию и передайте задание снова.</translation>
        </message>
        <message>
            <source>The table has lost steps</source>
            <translation>Стол потерял шаги</translation>
        </message>
        <message>
            <source>The table keeps turning, runs to and fro, or the heads rise as it turns, without links; a job carries its own.</source>
            <translation>Стол вращается дальше, ходит туда и обратно, или головки поднимаются по ходу вращения без переходов; у задания это своё.</translation>
        </message>
        <message>
            <source>The Ψ index did not come where it was expected.</source>
            <translation>Ноль Ψ пришёл не там, где ожидался.</translation>
        </message>
        <message>
            <source>The Ψ index was expected at %1 pulses and came at %2. Likely the table was held or braked.</source>
            <translation>Ноль Ψ ожидался на %1 импульсах, а пришёл на %2. Вероятно, стол удержали или притормозили.</translation>
        </message>
        <message>
            <source>Theme</source>
            <translation>Оформление</translation>
        </message>
        <message>
            <source>Then keys move the machine (F9)</source>
            <translation>Тогда станок движется от клавиш (F9)</translation>
        </message>
        <message>
            <source>Then outputs can be switched one by one</source>
            <translation>Тогда выходы можно переключать по одному</translation>
        </message>
        <message>
            <source>Tick</source>
            <translation>Такт</translation>
        </message>
        <message>
            <source>Ticks by how late they were (logarithmic)</source>
            <translation>Такты по запаздыванию (логарифмически)</translation>
        </message>
        <message>
            <source>Ticks in which a step waited for its pin</source>
            <translation>Такты с ожиданием вывода</translation>
        </message>
        <message>
            <source>Ticks per second</source>
            <translation>Тактов в секунду</translation>
        </message>
        <message>
            <source>Ticks since the core started</source>
            <translation>Тактов с запуска ядра</translation>
        </message>
        <message>
            <source>Ticks were missed (%1 since the core started); motors may have lost steps.</source>
            <translation>Такты пропущены (с запуска ядра: %1); двигатели могли потерять шаги.</translation>
        </message>
        <message>
            <source>Time</source>
            <translation>Время</translation>
        </message>
        <message>
            <source>Timeline of the recording</source>
            <translation>Шкала времени записи</translation>
        </message>
        <message>
            <source>To the begin</source>
            <translation>К началу</translation>
        </message>
        <message>
            <source>To the end</source>
            <translation>К концу</translation>
        </message>
        <message>
            <source>To the entry before (Shift+N)</source>
            <translation>К предыдущей записи (Shift+N)</translation>
        </message>
        <message>
            <source>To the first point</source>
            <translation>К первой точке</translation>
        </message>
        <message>
            <source>To the next entry (N)</source>
            <translation>К следующей записи (N)</translation>
        </message>
        <message>
            <source>Tool over surface; a job carries its own.</source>
            <translation>Скорость инструмента по поверхности; у задания она своя.</translation>
        </message>
        <message>
            <source>Top</source>
            <translation>Сверху</translation>
        </message>
        <message>
            <source>Top speed that the motor follows (v_k).</source>
            <translation>Наибольшая скорость, за которой поспевает двигатель (v_k).</translation>
        </message>
        <message>
            <source>Total time</source>
            <translation>Общее время</translation>
        </message>
        <message>
            <source>Touch-off: the real tip stands this much further out than counted.</source>
            <translation>Касание: настоящее остриё стоит на столько дальше наружу, чем по счёту.</translation>
        </message>
        <message>
            <source>Undo all</source>
            <translation>Вернуть всё</translation>
        </message>
        <message>
            <source>Unrolled Ψ–Y map of radii</source>
            <translation>Развёртка радиусов Ψ–Y</translation>
        </message>
        <message>
            <source>Up axis</source>
            <translation>Ось вверх</translation>
        </message>
        <message>
            <source>Use the switch on the machine to stop it</source>
            <translation>Остановите станок его кнопкой</translation>
        </message>
        <message>
            <source>Verified</source>
            <translation>Проверено</translation>
        </message>
        <message>
            <source>WAITING</source>
            <translation>ЖДЁТ</translation>
        </message>
        <message>
            <source>Wait from spindle on to the first move inwards.</source>
            <translation>Ожидание от включения шпинделя до первого хода внутрь.</translation>
        </message>
        <message>
            <source>Warning</source>
            <translation>Предупреждение</translation>
        </message>
        <message>
            <source>Warnings</source>
            <translation>Предупреждения</translation>
        </message>
        <message>
            <source>Warnings and alarms</source>
            <translation>Предупреждения и аварии</translation>
        </message>
        <message>
            <source>What happened</source>
            <translation>Что произошло</translation>
        </message>
        <message>
            <source>What to do</source>
            <translation>Что делать</translation>
        </message>
        <message>
            <source>Whether the table has an index sensor.</source>
            <translation>Есть ли у стола датчик нуля.</translation>
        </message>
        <message>
            <source>Which messages are shown</source>
            <translation>Какие сообщения показаны</translation>
        </message>
        <message>
            <source>Wiring test</source>
            <translation>Проверка проводки</translation>
        </message>
        <message>
            <source>Wiring test: arm it first</source>
            <translation>Проверка проводки: сначала включите</translation>
        </message>
        <message>
            <source>Wiring test: switch the drives off first</source>
            <translation>Проверка проводки: сначала отключите приводы</translation>
        </message>
        <message>
            <source>Working the piece out: %1 %</source>
            <translation>Деталь вычисляется: %1 %</translation>
        </message>
        <message>
            <source>Y direction</source>
            <translation>Y направление</translation>
        </message>
        <message>
            <source>Y down</source>
            <translation>Y
вниз</translation>
        </message>
        <message>
            <source>Y enable</source>
            <translation>Y включение</translation>
        </message>
        <message>
            <source>Y limit</source>
            <translation>Y концевик</translation>
        </message>
        <message>
            <source>Y step</source>
            <translation>Y шаг</translation>
        </message>
        <message>
            <source>Y up</source>
            <translation>Y
вверх</translation>
        </message>
        <message>
            <source>Zero %1</source>
            <translation>Отсчёт %1</translation>
        </message>
        <message>
            <source>Zero: axis %1 is not homed</source>
            <translation>Отсчёт: ноль оси %1 не найден</translation>
        </message>
        <message>
            <source>Zero: the machine's profile is not known here</source>
            <translation>Отсчёт: профиль станка здесь неизвестен</translation>
        </message>
        <message>
            <source>a face needs at least three vertices</source>
            <translation>грани нужны не меньше трёх вершин</translation>
        </message>
        <message>
            <source>a facet needs three vertices</source>
            <translation>треугольнику нужны три вершины</translation>
        </message>
        <message>
            <source>a facet without endfacet</source>
            <translation>facet без endfacet</translation>
        </message>
        <message>
            <source>a recorded run is being replayed</source>
            <translation>повторяется записанный прогон</translation>
        </message>
        <message>
            <source>a recording is shown; leave replay first</source>
            <translation>показана запись; сначала выйдите из воспроизведения</translation>
        </message>
        <message>
            <source>alarm</source>
            <translation>авария</translation>
        </message>
        <message>
            <source>alarm: %1</source>
            <translation>авария: %1</translation>
        </message>
        <message>
            <source>alarm: %1, axis %2</source>
            <translation>авария: %1, ось %2</translation>
        </message>
        <message>
            <source>an output is being tested; end the test first</source>
            <translation>проверяется выход; сначала закончите проверку</translation>
        </message>
        <message>
            <source>as at the last</source>
            <translation>как при последней</translation>
        </message>
        <message>
            <source>as in the file</source>
            <translation>как в файле</translation>
        </message>
        <message>
            <source>as planned</source>
            <translation>по плану</translation>
        </message>
        <message>
            <source>assumed</source>
            <translation>предположен</translation>
        </message>
        <message>
            <source>at least %1</source>
            <translation>не меньше %1</translation>
        </message>
        <message>
            <source>back-off</source>
            <translation>отвод</translation>
        </message>
        <message>
            <source>backing off</source>
            <translation>отводится</translation>
        </message>
        <message>
            <source>became shorter while it was read</source>
            <translation>стал короче во время чтения</translation>
        </message>
        <message>
            <source>being made</source>
            <translation>составляется</translation>
        </message>
        <message>
            <source>blank ⌀ %1</source>
            <translation>заготовка ⌀ %1</translation>
        </message>
        <message>
            <source>box centre</source>
            <translation>центр</translation>
        </message>
        <message>
            <source>built-in profile</source>
            <translation>встроенный профиль</translation>
        </message>
        <message>
            <source>cannot be opened: %1</source>
            <translation>не открывается: %1</translation>
        </message>
        <message>
            <source>cannot be read: %1</source>
            <translation>не читается: %1</translation>
        </message>
        <message>
            <source>carved to the last point</source>
            <translation>вырезано до последней точки</translation>
        </message>
        <message>
            <source>carving</source>
            <translation>резьба</translation>
        </message>
        <message>
            <source>checked</source>
            <translation>проверено</translation>
        </message>
        <message>
            <source>core lost</source>
            <translation>ядро потеряно</translation>
        </message>
        <message>
            <source>cut off</source>
            <translation>обрезана</translation>
        </message>
        <message>
            <source>cut off, or not an STL file: the header announces %1 facets, the file has room for %2</source>
            <translation>обрезан или не STL: заголовок обещает граней: %1, в файле место для %2</translation>
        </message>
        <message>
            <source>cut off: a binary STL begins with 84 bytes, the file has %1</source>
            <translation>обрезан: двоичный STL начинается с 84 байт, в файле их %1</translation>
        </message>
        <message>
            <source>cut off: it ends without endsolid, and the mesh has holes</source>
            <translation>обрезан: в конце нет endsolid, и в сетке дыры</translation>
        </message>
        <message>
            <source>cut off: its header is not complete</source>
            <translation>обрезан: заголовок неполон</translation>
        </message>
        <message>
            <source>cut off: the PLY header has no end_header</source>
            <translation>обрезан: в заголовке PLY нет end_header</translation>
        </message>
        <message>
            <source>damaged: its checksum is wrong</source>
            <translation>повреждён: неверная контрольная сумма</translation>
        </message>
        <message>
            <source>damaged: sizes and offsets do not fit each other</source>
            <translation>повреждён: размеры и смещения не сходятся</translation>
        </message>
        <message>
            <source>done</source>
            <translation>готово</translation>
        </message>
        <message>
            <source>drives-off</source>
            <translation>выключить приводы</translation>
        </message>
        <message>
            <source>emergency stop</source>
            <translation>аварийный останов</translation>
        </message>
        <message>
            <source>ended at layer %1 of %2</source>
            <translation>закончено на слое %1 из %2</translation>
        </message>
        <message>
            <source>ended by an alarm</source>
            <translation>прервано аварией</translation>
        </message>
        <message>
            <source>file version %1, this program knows %2: make the file anew</source>
            <translation>версия файла %1, программа знает %2: создайте файл заново</translation>
        </message>
        <message>
            <source>file's origin</source>
            <translation>ноль файла</translation>
        </message>
        <message>
            <source>finishing</source>
            <translation>завершение</translation>
        </message>
        <message>
            <source>from here on a tick may have been missed</source>
            <translation>отсюда такт мог быть пропущен</translation>
        </message>
        <message>
            <source>from the pins</source>
            <translation>с выводов</translation>
        </message>
        <message>
            <source>granted</source>
            <translation>есть</translation>
        </message>
        <message>
            <source>ground</source>
            <translation>земля</translation>
        </message>
        <message>
            <source>guard lost</source>
            <translation>потерян сторож</translation>
        </message>
        <message>
            <source>height</source>
            <translation>высота</translation>
        </message>
        <message>
            <source>held</source>
            <translation>пауза</translation>
        </message>
        <message>
            <source>high</source>
            <translation>высокий</translation>
        </message>
        <message>
            <source>hold</source>
            <translation>пауза</translation>
        </message>
        <message>
            <source>holding</source>
            <translation>замедляется до паузы</translation>
        </message>
        <message>
            <source>holds no facets (%1)</source>
            <translation>не содержит граней (%1)</translation>
        </message>
        <message>
            <source>holds no job</source>
            <translation>не содержит задания</translation>
        </message>
        <message>
            <source>home</source>
            <translation>поиск нуля</translation>
        </message>
        <message>
            <source>home ?</source>
            <translation>ноль ?</translation>
        </message>
        <message>
            <source>home failed</source>
            <translation>ноль не найден</translation>
        </message>
        <message>
            <source>home first</source>
            <translation>сначала найдите ноль</translation>
        </message>
        <message>
            <source>homed</source>
            <translation>ноль</translation>
        </message>
        <message>
            <source>homing</source>
            <translation>поиск нуля</translation>
        </message>
        <message>
            <source>in</source>
            <translation>вход</translation>
        </message>
        <message>
            <source>in it</source>
            <translation>в записи</translation>
        </message>
        <message>
            <source>info</source>
            <translation>сведения</translation>
        </message>
        <message>
            <source>is a folder, not a model file</source>
            <translation>это папка, а не файл модели</translation>
        </message>
        <message>
            <source>is a zip archive, but holds no 3MF model</source>
            <translation>это архив zip, но без модели 3MF</translation>
        </message>
        <message>
            <source>is no 3MF file: these are zip archives</source>
            <translation>не файл 3MF: это архивы zip</translation>
        </message>
        <message>
            <source>is no psicarve job or snapshot file</source>
            <translation>не файл задания или снимка psicarve</translation>
        </message>
        <message>
            <source>is not a regular file</source>
            <translation>не обычный файл</translation>
        </message>
        <message>
            <source>jog</source>
            <translation>ручное перемещение</translation>
        </message>
        <message>
            <source>larger than the machine's travel: axis %1 would have to go to %2 mm, allowed are %3; choose a smaller height</source>
            <translation>больше хода станка: оси %1 пришлось бы идти до %2 mm, допустимо %3; выберите меньшую высоту</translation>
        </message>
        <message>
            <source>last known</source>
            <translation>последнее известное</translation>
        </message>
        <message>
            <source>last known %1</source>
            <translation>последнее от %1</translation>
        </message>
        <message>
            <source>layer %1, point %2: the radius of %3, %4, is inside the core radius of %5; carve less deep, or lower core_radius_mm</source>
            <translation>слой %1, точка %2: радиус %3, %4, внутри радиуса сердцевины %5; режьте мельче или уменьшите core_radius_mm</translation>
        </message>
        <message>
            <source>least lost</source>
            <translation>мин. потеря</translation>
        </message>
        <message>
            <source>left</source>
            <translation>левая</translation>
        </message>
        <message>
            <source>limit</source>
            <translation>концевик</translation>
        </message>
        <message>
            <source>line %1</source>
            <translation>строка %1</translation>
        </message>
        <message>
            <source>linear</source>
            <translation>лин.</translation>
        </message>
        <message>
            <source>locked</source>
            <translation>заперто</translation>
        </message>
        <message>
            <source>looking for the best axis was cancelled</source>
            <translation>поиск лучшей оси отменён</translation>
        </message>
        <message>
            <source>low</source>
            <translation>низкий</translation>
        </message>
        <message>
            <source>missed %1</source>
            <translation>пропущено %1</translation>
        </message>
        <message>
            <source>missed ticks</source>
            <translation>пропущены такты</translation>
        </message>
        <message>
            <source>missing</source>
            <translation>нет</translation>
        </message>
        <message>
            <source>more layers than pulses: %1 layers, but the model is only %2 mm, %3 pulses of axis Y, high: choose at most %4 layers, or a larger height</source>
            <translation>слоёв больше, чем импульсов: %1, а высота модели лишь %2 mm, %3 импульсов оси Y: выберите не больше %4 слоёв или большую высоту</translation>
        </message>
        <message>
            <source>more points than pulses: %1 points a layer, but half a turn of axis Ψ has %2 pulses: choose at most %3 points</source>
            <translation>точек больше, чем импульсов: %1 в слое, а в половине оборота оси Ψ их %2: выберите не больше %3 точек</translation>
        </message>
        <message>
            <source>move</source>
            <translation>перемещение</translation>
        </message>
        <message>
            <source>moving</source>
            <translation>движется</translation>
        </message>
        <message>
            <source>no core</source>
            <translation>нет ядра</translation>
        </message>
        <message>
            <source>no core serves segment %1</source>
            <translation>сегмент %1 не обслуживает ни одно ядро</translation>
        </message>
        <message>
            <source>no job</source>
            <translation>нет задания</translation>
        </message>
        <message>
            <source>no job is published; publish one first</source>
            <translation>задание не опубликовано; сначала опубликуйте</translation>
        </message>
        <message>
            <source>no pin</source>
            <translation>нет вывода</translation>
        </message>
        <message>
            <source>no such file</source>
            <translation>нет такого файла</translation>
        </message>
        <message>
            <source>no. %1</source>
            <translation>№ %1</translation>
        </message>
        <message>
            <source>none</source>
            <translation>нет</translation>
        </message>
        <message>
            <source>none: add it</source>
            <translation>нет: добавьте</translation>
        </message>
        <message>
            <source>none: ticks may be late</source>
            <translation>нет: такты могут запаздывать</translation>
        </message>
        <message>
            <source>not a mesh that can be read here (STL, OBJ, PLY, 3MF or OFF)</source>
            <translation>не сетка, которую можно здесь прочесть (STL, OBJ, PLY, 3MF или OFF)</translation>
        </message>
        <message>
            <source>not by the window; psicarve carve does</source>
            <translation>не окном; это делает psicarve carve</translation>
        </message>
        <message>
            <source>not enough memory for so many layers and points</source>
            <translation>не хватает памяти на столько слоёв и точек</translation>
        </message>
        <message>
            <source>not enough memory to slice %1</source>
            <translation>не хватает памяти, чтобы нарезать %1</translation>
        </message>
        <message>
            <source>not in a trace</source>
            <translation>в трассе нет</translation>
        </message>
        <message>
            <source>not known</source>
            <translation>неизвестно</translation>
        </message>
        <message>
            <source>not needed</source>
            <translation>не нужны</translation>
        </message>
        <message>
            <source>not recorded</source>
            <translation>не записано</translation>
        </message>
        <message>
            <source>not sliced</source>
            <translation>не нарезано</translation>
        </message>
        <message>
            <source>not while %1; %2</source>
            <translation>нельзя в состоянии «%1»; %2</translation>
        </message>
        <message>
            <source>of %1</source>
            <translation>из %1</translation>
        </message>
        <message>
            <source>off</source>
            <translation>выключен</translation>
        </message>
        <message>
            <source>only in a trace</source>
            <translation>только в трассе</translation>
        </message>
        <message>
            <source>only with the drives off</source>
            <translation>только при выключенных приводах</translation>
        </message>
        <message>
            <source>open a model</source>
            <translation>откройте модель</translation>
        </message>
        <message>
            <source>opening was cancelled</source>
            <translation>открытие отменено</translation>
        </message>
        <message>
            <source>out</source>
            <translation>выход</translation>
        </message>
        <message>
            <source>override</source>
            <translation>коррекция</translation>
        </message>
        <message>
            <source>passed</source>
            <translation>пройдено</translation>
        </message>
        <message>
            <source>plan starved</source>
            <translation>расчёт не успел</translation>
        </message>
        <message>
            <source>port error</source>
            <translation>сбой порта</translation>
        </message>
        <message>
            <source>positioning</source>
            <translation>выход на точку</translation>
        </message>
        <message>
            <source>profile %1</source>
            <translation>профиль %1</translation>
        </message>
        <message>
            <source>profile unknown</source>
            <translation>профиль неизвестен</translation>
        </message>
        <message>
            <source>psicarve-hmi --opengl tries it again</source>
            <translation>psicarve-hmi --opengl попробует снова</translation>
        </message>
        <message>
            <source>publish first</source>
            <translation>передайте</translation>
        </message>
        <message>
            <source>publishing was cancelled</source>
            <translation>публикация отменена</translation>
        </message>
        <message>
            <source>pul.</source>
            <translation>имп.</translation>
        </message>
        <message>
            <source>pulses</source>
            <translation>имп.</translation>
        </message>
        <message>
            <source>radius %1 to %2 mm</source>
            <translation>радиус от %1 до %2 mm</translation>
        </message>
        <message>
            <source>reachable</source>
            <translation>достижимо</translation>
        </message>
        <message>
            <source>ready</source>
            <translation>готов</translation>
        </message>
        <message>
            <source>real clock</source>
            <translation>настоящие часы</translation>
        </message>
        <message>
            <source>record</source>
            <translation>запись</translation>
        </message>
        <message>
            <source>recorded</source>
            <translation>записано</translation>
        </message>
        <message>
            <source>reset first</source>
            <translation>сбросьте</translation>
        </message>
        <message>
            <source>reset the alarm first</source>
            <translation>сначала сбросьте аварию</translation>
        </message>
        <message>
            <source>reset-alarm</source>
            <translation>сброс аварии</translation>
        </message>
        <message>
            <source>reset-height</source>
            <translation>сброс высоты</translation>
        </message>
        <message>
            <source>resume</source>
            <translation>продолжить</translation>
        </message>
        <message>
            <source>resume, or stop</source>
            <translation>продолжите или остановите</translation>
        </message>
        <message>
            <source>right</source>
            <translation>правая</translation>
        </message>
        <message>
            <source>segment %1</source>
            <translation>сегмент %1</translation>
        </message>
        <message>
            <source>segment lost</source>
            <translation>сегмент потерян</translation>
        </message>
        <message>
            <source>shutdown</source>
            <translation>завершение</translation>
        </message>
        <message>
            <source>silent</source>
            <translation>молчит</translation>
        </message>
        <message>
            <source>slice first</source>
            <translation>нарежьте</translation>
        </message>
        <message>
            <source>slicing was cancelled</source>
            <translation>нарезка отменена</translation>
        </message>
        <message>
            <source>spindle</source>
            <translation>шпиндель</translation>
        </message>
        <message>
            <source>start</source>
            <translation>пуск</translation>
        </message>
        <message>
            <source>start first</source>
            <translation>сначала запустите</translation>
        </message>
        <message>
            <source>start, or stop</source>
            <translation>запустите или остановите</translation>
        </message>
        <message>
            <source>start-interpolation</source>
            <translation>начать резьбу</translation>
        </message>
        <message>
            <source>steps lost</source>
            <translation>потеря шагов</translation>
        </message>
        <message>
            <source>still tripped: %1; release it or back off</source>
            <translation>ещё сработал: %1; освободите или отведите ось</translation>
        </message>
        <message>
            <source>stopped</source>
            <translation>остановлено</translation>
        </message>
        <message>
            <source>stopping</source>
            <translation>останавливается</translation>
        </message>
        <message>
            <source>test-pin</source>
            <translation>проверка контакта</translation>
        </message>
        <message>
            <source>testing</source>
            <translation>проверка</translation>
        </message>
        <message>
            <source>the archive unpacks to far more than a model needs</source>
            <translation>архив распаковывается в объём, много больший, чем нужно модели</translation>
        </message>
        <message>
            <source>the axis has no sensor</source>
            <translation>у оси нет датчика</translation>
        </message>
        <message>
            <source>the core did not answer within %1 ms</source>
            <translation>ядро не ответило за %1 ms</translation>
        </message>
        <message>
            <source>the core ended before it answered</source>
            <translation>ядро завершилось, не ответив</translation>
        </message>
        <message>
            <source>the core of segment %1 (process %2) is silent</source>
            <translation>ядро сегмента %1 (процесс %2) молчит</translation>
        </message>
        <message>
            <source>the face names a vertex that is not there</source>
            <translation>грань называет вершину, которой нет</translation>
        </message>
        <message>
            <source>the file ends in the middle of a facet</source>
            <translation>файл кончается посреди треугольника</translation>
        </message>
        <message>
            <source>the file is empty</source>
            <translation>файл пуст</translation>
        </message>
        <message>
            <source>the job has not so many layers</source>
            <translation>в задании нет столько слоёв</translation>
        </message>
        <message>
            <source>the job was made for another machine (%1 differ); slice it again with the machine's profile</source>
            <translation>задание сделано для другого станка (отличаются: %1); нарежьте заново с профилем станка</translation>
        </message>
        <message>
            <source>the job's</source>
            <translation>из задания</translation>
        </message>
        <message>
            <source>the machine came to rest (%1), somebody stopped it</source>
            <translation>станок остановился (%1), его кто-то остановил</translation>
        </message>
        <message>
            <source>the machine is not homed; home first</source>
            <translation>ноль станка не найден; сначала найдите ноль</translation>
        </message>
        <message>
            <source>the mesh has no volume (all of it is flat); there is nothing to carve</source>
            <translation>у сетки нет объёма (вся плоская); резать нечего</translation>
        </message>
        <message>
            <source>the switch of the axis is open; there is nothing to back off from</source>
            <translation>выключатель оси разомкнут; отводить не от чего</translation>
        </message>
        <message>
            <source>the zip archive is cut off or damaged</source>
            <translation>архив zip обрезан или повреждён</translation>
        </message>
        <message>
            <source>there is no alarm</source>
            <translation>аварии нет</translation>
        </message>
        <message>
            <source>tick %1 µs</source>
            <translation>такт %1 µs</translation>
        </message>
        <message>
            <source>tick gap</source>
            <translation>разрыв тактов</translation>
        </message>
        <message>
            <source>too deep %1 material left&lt;br&gt;±%2 mm, ±%3 pulses</source>
            <translation>слишком глубоко %1 остался материал&lt;br&gt;±%2 mm, ±%3 имп.</translation>
        </message>
        <message>
            <source>too large for this computer's memory</source>
            <translation>не помещается в память компьютера</translation>
        </message>
        <message>
            <source>too many commands at once; wait for the others</source>
            <translation>слишком много команд сразу; подождите остальные</translation>
        </message>
        <message>
            <source>under way</source>
            <translation>выполняется</translation>
        </message>
        <message>
            <source>undercut %1 %</source>
            <translation>поднутрение %1 %</translation>
        </message>
        <message>
            <source>unknown</source>
            <translation>неизвестно</translation>
        </message>
        <message>
            <source>virtual clock</source>
            <translation>виртуальные часы</translation>
        </message>
        <message>
            <source>wait, or stop</source>
            <translation>подождите или остановите</translation>
        </message>
        <message>
            <source>waiting</source>
            <translation>ждёт</translation>
        </message>
        <message>
            <source>warning</source>
            <translation>внимание</translation>
        </message>
        <message>
            <source>was written by another build of psicarve</source>
            <translation>записан другой сборкой psicarve</translation>
        </message>
        <message>
            <source>whole</source>
            <translation>цела</translation>
        </message>
        <message>
            <source>× NO CORE</source>
            <translation>× НЕТ ЯДРА</translation>
        </message>
        <message>
            <source>Ψ and Y after R1 and R2, or with them; home R1 and R2 first</source>
            <translation>Ψ и Y после R1 и R2 или вместе с ними; сначала найдите ноль R1 и R2</translation>
        </message>
        <message>
            <source>Ψ axis</source>
            <translation>ось Ψ</translation>
        </message>
        <message>
            <source>Ψ direction</source>
            <translation>Ψ направление</translation>
        </message>
        <message>
            <source>Ψ enable</source>
            <translation>Ψ включение</translation>
        </message>
        <message>
            <source>Ψ index</source>
            <translation>Ψ ноль</translation>
        </message>
        <message>
            <source>Ψ index: away</source>
            <translation>Ноль Ψ: не здесь</translation>
        </message>
        <message>
            <source>Ψ index: there</source>
            <translation>Ноль Ψ: здесь</translation>
        </message>
        <message>
            <source>Ψ step</source>
            <translation>Ψ шаг</translation>
        </message>
        <message>
            <source>← → Ψ   ↑ ↓ Y   PgUp PgDn R1
Ctrl+PgUp PgDn R2   Shift one step</source>
            <translation>← → Ψ   ↑ ↓ Y   PgUp PgDn R1
Ctrl+PgUp PgDn R2   Shift один шаг</translation>
        </message>
        <message>
            <source>○ index</source>
            <translation>○ ноль</translation>
        </message>
        <message>
            <source>○ limit</source>
            <translation>○ КВ</translation>
        </message>
        <message>
            <source>● index</source>
            <translation>● ноль</translation>
        </message>
        <message>
            <source>✓ CORE ALIVE</source>
            <translation>✓ ЯДРО РАБОТАЕТ</translation>
        </message>
    </context>
</TS>
