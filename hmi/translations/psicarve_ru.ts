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
            <source> or </source>
            <translation> или </translation>
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
            <source>% stands among other things, or in the middle</source>
            <translation>% стоит среди другого или в середине программы</translation>
        </message>
        <message>
            <source>%1 % of the surface</source>
            <translation>%1 % поверхности</translation>
        </message>
        <message>
            <source>%1 MB, %2 faces</source>
            <translation>%1 МБ, граней: %2</translation>
        </message>
        <message>
            <source>%1 alone finds its home position</source>
            <translation>%1 один ищет свой ноль</translation>
        </message>
        <message>
            <source>%1 and %2 are both on output pin %3; give one of them another pin (only enables may share)</source>
            <translation>%1 и %2 оба на выходном выводе %3; дайте одному из них другой вывод (делить можно только сигналы разрешения)</translation>
        </message>
        <message>
            <source>%1 and %2 both use axis words</source>
            <translation>и %1, и %2 используют слова осей</translation>
        </message>
        <message>
            <source>%1 and %2 share pin %3, one active high and one active low; give both the same sign</source>
            <translation>%1 и %2 делят вывод %3: у одного активен высокий уровень, у другого низкий; дайте обоим один знак</translation>
        </message>
        <message>
            <source>%1 and %2 share pin %3: what homing looks for would be an emergency stop; give one of them another pin, or 0</source>
            <translation>%1 и %2 делят вывод %3: то, что ищет выход в ноль, было бы аварийным остановом; дайте одному из них другой вывод или 0</translation>
        </message>
        <message>
            <source>%1 and %2: %3 differences</source>
            <translation>%1 и %2: отличий %3</translation>
        </message>
        <message>
            <source>%1 and %2: nothing differs</source>
            <translation>%1 и %2: отличий нет</translation>
        </message>
        <message>
            <source>%1 behind else</source>
            <translation>%1 после else</translation>
        </message>
        <message>
            <source>%1 blocks in loops make no move, no dwell and no stop</source>
            <translation>%1 кадров в циклах без перемещения, выдержки и останова</translation>
        </message>
        <message>
            <source>%1 can only be read</source>
            <translation>%1 можно только читать</translation>
        </message>
        <message>
            <source>%1 cannot count so far</source>
            <translation>%1 не может отсчитать так далеко</translation>
        </message>
        <message>
            <source>%1 cannot stand at %2 mm; its travel is %3 to %4 mm</source>
            <translation>%1 не может стоять на %2 mm; её ход от %3 до %4 mm</translation>
        </message>
        <message>
            <source>%1 carries several jobs; it is shown with the first</source>
            <translation>%1 содержит несколько заданий; показано с первым</translation>
        </message>
        <message>
            <source>%1 cells</source>
            <translation>ячеек: %1</translation>
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
            <source>%1 cm³</source>
            <translation>%1 см³</translation>
        </message>
        <message>
            <source>%1 comes to %2 mm, and the core that it must not reach ends at %3 mm</source>
            <translation>%1 приходит в %2 mm, а сердцевина, в которую нельзя заходить, кончается на %3 mm</translation>
        </message>
        <message>
            <source>%1 comes to %2 mm, its travel is %3 mm to %4 mm</source>
            <translation>%1 приходит в %2 mm, её ход от %3 mm до %4 mm</translation>
        </message>
        <message>
            <source>%1 dir</source>
            <translation>%1 напр.</translation>
        </message>
        <message>
            <source>%1 en</source>
            <translation>%1 вкл.</translation>
        </message>
        <message>
            <source>%1 ended: %2</source>
            <translation>%1: программа закончилась: %2</translation>
        </message>
        <message>
            <source>%1 entries</source>
            <translation>записей: %1</translation>
        </message>
        <message>
            <source>%1 faces</source>
            <translation>граней: %1</translation>
        </message>
        <message>
            <source>%1 facets</source>
            <translation>%1 граней</translation>
        </message>
        <message>
            <source>%1 facets, %2 cm³</source>
            <translation>%1 граней, %2 см³</translation>
        </message>
        <message>
            <source>%1 found its sensor</source>
            <translation>%1: датчик найден</translation>
        </message>
        <message>
            <source>%1 free in /dev/shm</source>
            <translation>свободно в /dev/shm: %1</translation>
        </message>
        <message>
            <source>%1 goes at %2 at most, and so it does</source>
            <translation>%1 идёт не быстрее %2, так и идёт</translation>
        </message>
        <message>
            <source>%1 has a value of more than 1000000000</source>
            <translation>значение %1 больше 1000000000</translation>
        </message>
        <message>
            <source>%1 has no %2, the depth</source>
            <translation>у %1 нет %2, глубины</translation>
        </message>
        <message>
            <source>%1 has no P, the dwell</source>
            <translation>у %1 нет P, выдержки</translation>
        </message>
        <message>
            <source>%1 has no P, the number</source>
            <translation>у %1 нет P, номера</translation>
        </message>
        <message>
            <source>%1 has no Q, the depth of a peck</source>
            <translation>у %1 нет Q, глубины одного захода</translation>
        </message>
        <message>
            <source>%1 has no R</source>
            <translation>у %1 нет R</translation>
        </message>
        <message>
            <source>%1 has no axis word</source>
            <translation>у %1 нет слова оси</translation>
        </message>
        <message>
            <source>%1 has no closed outline: its lines are engraved</source>
            <translation>%1: нет замкнутого контура, гравируются линии</translation>
        </message>
        <message>
            <source>%1 has no number</source>
            <translation>у %1 нет числа</translation>
        </message>
        <message>
            <source>%1 has no value</source>
            <translation>у %1 нет значения</translation>
        </message>
        <message>
            <source>%1 has no value in [ ]</source>
            <translation>у %1 нет значения в [ ]</translation>
        </message>
        <message>
            <source>%1 has no way left in this direction</source>
            <translation>у %1 в эту сторону больше нет хода</translation>
        </message>
        <message>
            <source>%1 in a system that is rotated</source>
            <translation>%1 в повёрнутой системе координат</translation>
        </message>
        <message>
            <source>%1 in use</source>
            <translation>используется: %1</translation>
        </message>
        <message>
            <source>%1 is above the axis' top speed of %2; lower it, or raise %3</source>
            <translation>%1 больше наибольшей скорости оси, %2; уменьшите значение или увеличьте %3</translation>
        </message>
        <message>
            <source>%1 is half a revolution of %2 pulses or more, so lost steps would never be noticed; lower it</source>
            <translation>%1 — это пол-оборота из %2 импульсов или больше, и потерянные шаги не были бы замечены; уменьшите значение</translation>
        </message>
        <message>
            <source>%1 is impossible; give a value from %2 to %3</source>
            <translation>%1 недопустимо; задайте значение от %2 до %3</translation>
        </message>
        <message>
            <source>%1 is less than 0</source>
            <translation>%1 меньше 0</translation>
        </message>
        <message>
            <source>%1 is no group code</source>
            <translation>%1 — не код группы</translation>
        </message>
        <message>
            <source>%1 is no head of a table: y_mm,r_mm or y_pulses,r_pulses, or what snapshot export writes</source>
            <translation>%1 — не заголовок таблицы: нужен y_mm,r_mm, или y_pulses,r_pulses, или то, что пишет snapshot export</translation>
        </message>
        <message>
            <source>%1 is no number to work with; give a finite one</source>
            <translation>%1 — не пригодное число; задайте конечное</translation>
        </message>
        <message>
            <source>%1 is no whole number</source>
            <translation>%1 — не целое число</translation>
        </message>
        <message>
            <source>%1 is no word of an arc in %2</source>
            <translation>%1 — не слово дуги в %2</translation>
        </message>
        <message>
            <source>%1 is not a number</source>
            <translation>%1 — не число</translation>
        </message>
        <message>
            <source>%1 is not a number that a table can hold</source>
            <translation>%1 — не число, возможное в таблице</translation>
        </message>
        <message>
            <source>%1 is not a number: a vertex needs three</source>
            <translation>%1 — не число: вершине нужны три</translation>
        </message>
        <message>
            <source>%1 is not a whole number</source>
            <translation>%1 — не целое число</translation>
        </message>
        <message>
            <source>%1 is not a word of ASCII STL</source>
            <translation>%1 — не слово текстового STL</translation>
        </message>
        <message>
            <source>%1 is not known</source>
            <translation>%1 неизвестно</translation>
        </message>
        <message>
            <source>%1 is not possible here; give %2</source>
            <translation>%1 здесь недопустимо; задайте %2</translation>
        </message>
        <message>
            <source>%1 is not the number of a vertex</source>
            <translation>%1 — не номер вершины</translation>
        </message>
        <message>
            <source>%1 is not there</source>
            <translation>%1 отсутствует</translation>
        </message>
        <message>
            <source>%1 is not this trace's job: the heads were elsewhere at %2 of %3 places that were looked at</source>
            <translation>%1: не задание этой записи: в %2 из %3 просмотренных мест головки стояли иначе</translation>
        </message>
        <message>
            <source>%1 is not wired to any pin</source>
            <translation>%1 не подключён ни к одному контакту</translation>
        </message>
        <message>
            <source>%1 is odd, so half a revolution is no whole number of pulses; give an even number</source>
            <translation>%1 нечётно, и пол-оборота не целое число импульсов; задайте чётное число</translation>
        </message>
        <message>
            <source>%1 is run.</source>
            <translation>%1: программа выполнена.</translation>
        </message>
        <message>
            <source>%1 layers</source>
            <translation>Слоёв: %1</translation>
        </message>
        <message>
            <source>%1 layers can be wrong, from layer %2 on%3</source>
            <translation>Слоёв под сомнением: %1, начиная со слоя %2%3</translation>
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
            <source>%1 lies beside this trace, but is of another run: it is not used</source>
            <translation>%1 лежит рядом с этой записью, но от другого запуска: не используется</translation>
        </message>
        <message>
            <source>%1 limit</source>
            <translation>%1 КВ</translation>
        </message>
        <message>
            <source>%1 limit switch: closed</source>
            <translation>концевой выключатель %1: замкнут</translation>
        </message>
        <message>
            <source>%1 limit switch: not known</source>
            <translation>концевой выключатель %1: неизвестно</translation>
        </message>
        <message>
            <source>%1 limit switch: open</source>
            <translation>концевой выключатель %1: разомкнут</translation>
        </message>
        <message>
            <source>%1 may not be written</source>
            <translation>в %1 нельзя писать</translation>
        </message>
        <message>
            <source>%1 missed</source>
            <translation>пропущено: %1</translation>
        </message>
        <message>
            <source>%1 mm</source>
            <translation>%1 mm</translation>
        </message>
        <message>
            <source>%1 mm as the max sensor's edge leaves nothing of the travel of %2 to %3 mm; put it at the travel's upper end, or correct %4</source>
            <translation>%1 mm как край датчика max не оставляет ничего от хода от %2 до %3 mm; поставьте его на верхний конец хода или исправьте %4</translation>
        </message>
        <message>
            <source>%1 mm as the min sensor's edge leaves nothing of the travel of %2 to %3 mm; put it at the travel's lower end, or correct %4</source>
            <translation>%1 mm как край датчика min не оставляет ничего от хода от %2 до %3 mm; поставьте его на нижний конец хода или исправьте %4</translation>
        </message>
        <message>
            <source>%1 mm beside</source>
            <translation>рядом, %1 мм</translation>
        </message>
        <message>
            <source>%1 mm deep goes to the middle of a cylinder of %2 mm diameter</source>
            <translation>глубина %1 mm доходит до середины цилиндра диаметром %2 mm</translation>
        </message>
        <message>
            <source>%1 mm is more than the tips are apart with both heads out, %2 mm; lower it</source>
            <translation>%1 мм больше, чем расстояние между остриями при обеих отведённых головках, %2 мм; уменьшите</translation>
        </message>
        <message>
            <source>%1 mm is more than the tool is wide, %2 mm; set it lower, or to 0</source>
            <translation>%1 mm больше ширины инструмента, %2 mm; уменьшите значение или задайте 0</translation>
        </message>
        <message>
            <source>%1 mm is out of the reach of head %2; lower it, or widen %3</source>
            <translation>до %1 mm головка %2 не достаёт; уменьшите значение или расширьте %3</translation>
        </message>
        <message>
            <source>%1 mm lies outside the travel of %2 to %3 mm by more than the %4 mm of overtravel; give a position that the axis can reach</source>
            <translation>%1 mm лежит вне хода от %2 до %3 mm больше чем на перебег %4 mm; укажите положение, до которого ось доходит</translation>
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
            <source>%1 more</source>
            <translation>и ещё %1</translation>
        </message>
        <message>
            <source>%1 more came too fast to be written down</source>
            <translation>Ещё %1: шли слишком быстро и не записаны</translation>
        </message>
        <message>
            <source>%1 ms</source>
            <translation>%1 мс</translation>
        </message>
        <message>
            <source>%1 numbers, not %2</source>
            <translation>чисел %1, а не %2</translation>
        </message>
        <message>
            <source>%1 of %2</source>
            <translation>%1 из %2</translation>
        </message>
        <message>
            <source>%1 of %2 facets have no finite coordinates; this is not a usable mesh</source>
            <translation>у %1 из %2 граней координаты не конечны; такая сетка непригодна</translation>
        </message>
        <message>
            <source>%1 of %2 has no end</source>
            <translation>у %1 слова %2 нет конца</translation>
        </message>
        <message>
            <source>%1 of %2 layers do not contain the axis.</source>
            <translation>Слоёв, не содержащих ось: %1 из %2.</translation>
        </message>
        <message>
            <source>%1 of %2 layers do not contain the axis. Axis at: least lost looks for an axis that loses less.</source>
            <translation>Слоёв, не содержащих ось: %1 из %2. «Ось проходит: мин. потеря» ищет ось с меньшими потерями.</translation>
        </message>
        <message>
            <source>%1 of %2 layers do not contain the axis. With Axis at: least lost, %3 of the surface and %4 of the layers would be lost; by the same look this axis loses %5 and %6.</source>
            <translation>Слоёв, не содержащих ось: %1 из %2. С «Ось проходит: мин. потеря» потеря составит %3 поверхности и %4 слоёв; при таком же подсчёте эта ось теряет %5 и %6.</translation>
        </message>
        <message>
            <source>%1 of %2 pass</source>
            <translation>пройдено %1 из %2</translation>
        </message>
        <message>
            <source>%1 of %2 pass, %3 to look at</source>
            <translation>%1 из %2, взглянуть: %3</translation>
        </message>
        <message>
            <source>%1 of %2 s, %3 missed, at most %4 late</source>
            <translation>%1 из %2 с, пропущено %3, опоздание не больше %4</translation>
        </message>
        <message>
            <source>%1 of %2 strokes are narrower than the tool cuts, %3 mm: they become as wide as that.</source>
            <translation>Линий уже, чем режет инструмент (%3 mm): %1 из %2; они станут такой ширины.</translation>
        </message>
        <message>
            <source>%1 of %2 within %3 of %4</source>
            <translation>%1 слова %2 внутри %3 слова %4</translation>
        </message>
        <message>
            <source>%1 of %2, %3°</source>
            <translation>%1 из %2, %3°</translation>
        </message>
        <message>
            <source>%1 of %2: %3</source>
            <translation>%1 из %2: %3</translation>
        </message>
        <message>
            <source>%1 of the points stand at the core radius of %2 mm: what lies inside it is not carved; a larger model or a smaller core_radius_mm loses less.</source>
            <translation>%1 точек стоят на радиусе сердцевины %2 mm: то, что внутри него, не вырезается; с моделью крупнее или меньшим core_radius_mm потери меньше.</translation>
        </message>
        <message>
            <source>%1 of the points stand at the radius of %2 mm at which the heads' travel ends: what lies inside it is not carved; a larger model or a travel_mm that goes further in loses less.</source>
            <translation>%1 точек стоят на радиусе %2 mm, на котором кончается ход головок: то, что внутри него, не вырезается; с моделью крупнее или travel_mm дальше внутрь потери меньше.</translation>
        </message>
        <message>
            <source>%1 of the surface lies behind another part and cannot be reached.</source>
            <translation>%1 поверхности заслонено другой частью и недостижимо.</translation>
        </message>
        <message>
            <source>%1 of the surface lies behind another part and cannot be reached. Axis at: least lost looks for an axis that loses less.</source>
            <translation>%1 поверхности заслонено другой частью и недостижимо. «Ось проходит: мин. потеря» ищет ось с меньшими потерями.</translation>
        </message>
        <message>
            <source>%1 of the surface lies behind another part and cannot be reached. With Axis at: least lost, %2 of the surface and %3 of the layers would be lost; by the same look this axis loses %4 and %5.</source>
            <translation>%1 поверхности заслонено другой частью и недостижимо. С «Ось проходит: мин. потеря» потеря составит %2 поверхности и %3 слоёв; при таком же подсчёте эта ось теряет %4 и %5.</translation>
        </message>
        <message>
            <source>%1 outside the loop %2</source>
            <translation>%1 вне цикла %2</translation>
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
            <source>%1 points in a layer of %2 pulses of Ψ; slice with at most %3 points</source>
            <translation>%1 точек в слое из %2 импульсов Ψ; нарежьте не более чем с %3 точками</translation>
        </message>
        <message>
            <source>%1 pulses</source>
            <translation>импульсов: %1</translation>
        </message>
        <message>
            <source>%1 pulses counted; the simulated machine stands at %2</source>
            <translation>сосчитано импульсов: %1; имитируемый станок стоит на %2</translation>
        </message>
        <message>
            <source>%1 pulses, of what was carved</source>
            <translation>импульсов: %1, у вырезанного</translation>
        </message>
        <message>
            <source>%1 radii, but the layers before have %2</source>
            <translation>радиусов %1, а в предыдущих слоях их %2</translation>
        </message>
        <message>
            <source>%1 records could not be written into the journal</source>
            <translation>Не удалось записать в журнал записей: %1</translation>
        </message>
        <message>
            <source>%1 roughing, finishing</source>
            <translation>черновых: %1, чистовой</translation>
        </message>
        <message>
            <source>%1 runs, of another process. %2</source>
            <translation>Идёт %1 другого процесса. %2</translation>
        </message>
        <message>
            <source>%1 runs. %2</source>
            <translation>Идёт %1. %2</translation>
        </message>
        <message>
            <source>%1 since layer %2, when this window came</source>
            <translation>%1 со слоя %2, когда открылось это окно</translation>
        </message>
        <message>
            <source>%1 stands beside %2</source>
            <translation>%1 стоит рядом с %2</translation>
        </message>
        <message>
            <source>%1 stands beside %2 of its group</source>
            <translation>%1 стоит рядом с %2 той же группы</translation>
        </message>
        <message>
            <source>%1 stands twice in the block</source>
            <translation>%1 стоит в кадре дважды</translation>
        </message>
        <message>
            <source>%1 step</source>
            <translation>%1 шаг</translation>
        </message>
        <message>
            <source>%1 strokes are not closed and left out, the first from %2 to %3 mm.</source>
            <translation>Незамкнутых линий: %1, они пропущены; первая от %2 до %3 mm.</translation>
        </message>
        <message>
            <source>%1 takes no more values</source>
            <translation>%1 не принимает больше значений</translation>
        </message>
        <message>
            <source>%1 tells of another piece: see which of them is mounted.</source>
            <translation>%1 говорит о другой заготовке: посмотрите, какая из них установлена.</translation>
        </message>
        <message>
            <source>%1 tells of what this machine does not have</source>
            <translation>%1 говорит о том, чего у этого станка нет</translation>
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
            <source>%1 ticks missed, %2 since the core started</source>
            <translation>Пропущено тактов: %1, с запуска ядра: %2</translation>
        </message>
        <message>
            <source>%1 to %2 bytes</source>
            <translation>от %1 до %2 байт</translation>
        </message>
        <message>
            <source>%1 to %2 mm</source>
            <translation>%1–%2 mm</translation>
        </message>
        <message>
            <source>%1 turns</source>
            <translation>%1 об.</translation>
        </message>
        <message>
            <source>%1 us are too short for a pulse and its gap, which take %2 us in ticks; lengthen it, or shorten tick.period_us</source>
            <translation>%1 us мало для импульса с паузой: в тактах они занимают %2 us; увеличьте значение или сократите tick.period_us</translation>
        </message>
        <message>
            <source>%1 us is longer than the %2 us from pulse to pulse; shorten it, or lengthen tick.io_us</source>
            <translation>%1 us больше, чем %2 us от импульса до импульса; уменьшите значение или увеличьте tick.io_us</translation>
        </message>
        <message>
            <source>%1 us is no whole number of periods of %2 us; give a multiple of tick.period_us</source>
            <translation>%1 us — не целое число периодов по %2 us; задайте кратное tick.period_us</translation>
        </message>
        <message>
            <source>%1 was not opened</source>
            <translation>Файл %1 не открыт</translation>
        </message>
        <message>
            <source>%1 was written since it was opened: Reload takes it as it is now</source>
            <translation>Файл %1 изменён после открытия: «Перечитать» возьмёт его новым</translation>
        </message>
        <message>
            <source>%1 where %2 is expected; correct the value</source>
            <translation>здесь %1, а ожидается: %2; исправьте значение</translation>
        </message>
        <message>
            <source>%1 where the table [%2] is expected; put its keys below [%3]</source>
            <translation>здесь %1, а ожидается таблица [%2]; её ключи пишите под [%3]</translation>
        </message>
        <message>
            <source>%1 while %2 holds</source>
            <translation>%1 при действующем %2</translation>
        </message>
        <message>
            <source>%1 while a cycle holds</source>
            <translation>%1 при действующем цикле</translation>
        </message>
        <message>
            <source>%1 without %2 before it</source>
            <translation>%1 без %2 перед ним</translation>
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
            <source>%1 would take the feed's override from the operator</source>
            <translation>%1 отнял бы у оператора коррекцию подачи</translation>
        </message>
        <message>
            <source>%1 · ends %2</source>
            <translation>%1 · конец в %2</translation>
        </message>
        <message>
            <source>%1 · ends about %2</source>
            <translation>%1 · конец около %2</translation>
        </message>
        <message>
            <source>%1 × %2 × %3 mm, scale %4</source>
            <translation>%1 × %2 × %3 mm, масштаб %4</translation>
        </message>
        <message>
            <source>%1, %2 bytes</source>
            <translation>%1, %2 байт</translation>
        </message>
        <message>
            <source>%1, PREEMPT_RT</source>
            <translation>%1, PREEMPT_RT</translation>
        </message>
        <message>
            <source>%1, checked</source>
            <translation>%1, проверено</translation>
        </message>
        <message>
            <source>%1, facets: %2</source>
            <translation>%1, граней: %2</translation>
        </message>
        <message>
            <source>%1, held against %2</source>
            <translation>%1, сверка с %2</translation>
        </message>
        <message>
            <source>%1, not %2 of --profile</source>
            <translation>%1, а не %2 из --profile</translation>
        </message>
        <message>
            <source>%1, not PREEMPT_RT</source>
            <translation>%1, не PREEMPT_RT</translation>
        </message>
        <message>
            <source>%1, not checked</source>
            <translation>%1, не проверено</translation>
        </message>
        <message>
            <source>%1, not finished</source>
            <translation>%1, не закончено</translation>
        </message>
        <message>
            <source>%1, of another run</source>
            <translation>%1, от другого запуска</translation>
        </message>
        <message>
            <source>%1. Lose them?</source>
            <translation>%1. Отказаться от них?</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>%1: %2 to look at</source>
            <translation>%1: посмотреть %2</translation>
        </message>
        <message>
            <source>%1: %2 values become others</source>
            <translation>%1: изменятся значения: %2</translation>
        </message>
        <message>
            <source>%1: %2; %3</source>
            <translation>%1: %2; %3</translation>
        </message>
        <message>
            <source>%1: core %2, here %3</source>
            <translation>%1: в ядре %2, здесь %3</translation>
        </message>
        <message>
            <source>%1: cutter compensation is not done</source>
            <translation>%1: коррекция на инструмент не выполняется</translation>
        </message>
        <message>
            <source>%1: homed</source>
            <translation>%1: ноль найден</translation>
        </message>
        <message>
            <source>%1: it would not say what is shown here; open it again</source>
            <translation>%1: в файле оказалось бы не то, что показано здесь; откройте его снова</translation>
        </message>
        <message>
            <source>%1: its flight recorder tells of another run; its entries are not shown</source>
            <translation>%1: его самописец рассказывает о другом запуске; его записи не показаны</translation>
        </message>
        <message>
            <source>%1: line %2: %3 cannot be set as this is written; give its table a header, [%4], and each key a line below it</source>
            <translation>%1: строка %2: при такой записи %3 задать нельзя; дайте таблице заголовок [%4] и каждому ключу строку под ним</translation>
        </message>
        <message>
            <source>%1: line %2: %3 has no place: a table of that name stands here; rename it</source>
            <translation>%1: строка %2: для %3 нет места: здесь таблица с этим именем; переименуйте её</translation>
        </message>
        <message>
            <source>%1: line %2: %3 has no place: a value of that name stands here; rename it</source>
            <translation>%1: строка %2: для %3 нет места: здесь значение с этим именем; переименуйте его</translation>
        </message>
        <message>
            <source>%1: not found beside psicarve-hmi nor in PATH; install it there</source>
            <translation>%1: не найдено ни рядом с psicarve-hmi, ни в PATH; установите туда</translation>
        </message>
        <message>
            <source>%1: not homed</source>
            <translation>%1: ноль не найден</translation>
        </message>
        <message>
            <source>%1: one value becomes another</source>
            <translation>%1: изменится одно значение</translation>
        </message>
        <message>
            <source>%1: somebody has changed this file since it was opened; save under another name, or open it again and lose these changes</source>
            <translation>%1: этот файл кто-то изменил после открытия; сохраните под другим именем или откройте его снова и потеряйте эти изменения</translation>
        </message>
        <message>
            <source>%1: the machine has no input for it</source>
            <translation>%1: у станка нет такого входа</translation>
        </message>
        <message>
            <source>%1: the machine has no such output or input</source>
            <translation>%1: у станка нет такого выхода или входа</translation>
        </message>
        <message>
            <source>%1: there is no tool table</source>
            <translation>%1: таблицы инструментов нет</translation>
        </message>
        <message>
            <source>%1: whether it is homed is not known</source>
            <translation>%1: найден ли ноль, неизвестно</translation>
        </message>
        <message>
            <source>%1: whether it was homed is not recorded</source>
            <translation>%1: найден ли ноль, не записано</translation>
        </message>
        <message>
            <source>%1: work offsets cannot be kept: %2</source>
            <translation>%1: рабочие смещения нельзя сохранить: %2</translation>
        </message>
        <message>
            <source>%1–%2 mm high (%3 %)</source>
            <translation>на высоте %1–%2 mm (%3 %)</translation>
        </message>
        <message>
            <source>%1–%2°, through 0° (%3 %)</source>
            <translation>%1–%2°, через 0° (%3 %)</translation>
        </message>
        <message>
            <source>%2 (%1 times, here first)</source>
            <translation>%2 (раз: %1, здесь первый)</translation>
        </message>
        <message>
            <source>%2 (line %1 of the program)</source>
            <translation>%2 (строка %1 программы)</translation>
        </message>
        <message>
            <source>%2 · override %1 %</source>
            <translation>%2 · коррекция %1 %</translation>
        </message>
        <message>
            <source>%3 (layer %1, point %2)</source>
            <translation>%3 (слой %1, точка %2)</translation>
        </message>
        <message>
            <source>%3 where the table [%1] is expected; put its keys below [%2]</source>
            <translation>здесь %3, а ожидается таблица [%1]; её ключи пишите под [%2]</translation>
        </message>
        <message>
            <source>'%1' begins no word</source>
            <translation>с «%1» не начинается ни одно слово</translation>
        </message>
        <message>
            <source>'%1' is neither an operator nor ]</source>
            <translation>«%1» — не оператор и не ]</translation>
        </message>
        <message>
            <source>'%1...' is more than 1000000000</source>
            <translation>«%1...» больше 1000000000</translation>
        </message>
        <message>
            <source>(told of line %1)</source>
            <translation>(сведения о строке %1)</translation>
        </message>
        <message>
            <source>--port io:ADDRESS is refused</source>
            <translation>--port io:ADDRESS отклоняется</translation>
        </message>
        <message>
            <source>0 ms</source>
            <translation>0 мс</translation>
        </message>
        <message>
            <source>1 % later than %1</source>
            <translation>1 % позже %1</translation>
        </message>
        <message>
            <source>1 change not saved</source>
            <translation>не сохранено одно изменение</translation>
        </message>
        <message>
            <source>1 stroke is not closed and left out, from %1 to %2 mm.</source>
            <translation>Одна линия не замкнута и пропущена: от %1 до %2 mm.</translation>
        </message>
        <message>
            <source>1 to 10000 pulses, 1 to 500 in a second</source>
            <translation>от 1 до 10000 импульсов, от 1 до 500 в секунду</translation>
        </message>
        <message>
            <source>1 turn</source>
            <translation>1 об.</translation>
        </message>
        <message>
            <source>10 to 100 per cent of the speed of rapid ways, whole</source>
            <translation>от 10 до 100 процентов скорости быстрых перемещений, целое число</translation>
        </message>
        <message>
            <source>10 to 200 per cent of the planned feed, whole</source>
            <translation>от 10 до 200 % плановой подачи, целым числом</translation>
        </message>
        <message>
            <source>100 blocks within each other</source>
            <translation>100 вложенных блоков</translation>
        </message>
        <message>
            <source>100 calls within each other</source>
            <translation>100 вложенных вызовов</translation>
        </message>
        <message>
            <source>3 of 3</source>
            <translation>3 из 3</translation>
        </message>
        <message>
            <source>99 % of the ticks were no later; page Real time tells more</source>
            <translation>99 % тактов опаздывали не больше; подробнее на странице «Реальное время»</translation>
        </message>
        <message>
            <source>&lt; has no &gt;</source>
            <translation>у &lt; нет &gt;</translation>
        </message>
        <message>
            <source>&lt; is missing</source>
            <translation>нет &lt;</translation>
        </message>
        <message>
            <source>&lt;%1&gt; is left out.</source>
            <translation>&lt;%1&gt; пропущен.</translation>
        </message>
        <message>
            <source>&lt;%1&gt; is not right and left out.</source>
            <translation>&lt;%1&gt; с ошибкой и пропущен.</translation>
        </message>
        <message>
            <source>&lt;%1&gt; is not right; what follows the fault is left out.</source>
            <translation>&lt;%1&gt; с ошибкой; то, что за ней, пропущено.</translation>
        </message>
        <message>
            <source>&lt;switch&gt; holds nothing for every language and is left out.</source>
            <translation>в &lt;switch&gt; нет ничего для любого языка; пропущен.</translation>
        </message>
        <message>
            <source>&lt;use&gt; of something that is not in this file is left out.</source>
            <translation>&lt;use&gt; ссылается на то, чего нет в файле; пропущен.</translation>
        </message>
        <message>
            <source>? index</source>
            <translation>? метка</translation>
        </message>
        <message>
            <source>? limit</source>
            <translation>? КВ</translation>
        </message>
        <message>
            <source>A draft of what the tool will leave, before the model is sliced</source>
            <translation>Набросок того, что оставит инструмент, ещё до нарезки модели</translation>
        </message>
        <message>
            <source>A head moving in to its first point.</source>
            <translation>Скорость подвода головки к первой точке.</translation>
        </message>
        <message>
            <source>A job is being made; cancel it first</source>
            <translation>Создаётся задание; сначала отмените его</translation>
        </message>
        <message>
            <source>A message that is selected above stands here in full.</source>
            <translation>Здесь полностью показано сообщение, выбранное выше.</translation>
        </message>
        <message>
            <source>A new blank has to begin with layer 1.</source>
            <translation>Новую заготовку надо начинать со слоя 1.</translation>
        </message>
        <message>
            <source>A part of layer 1 of %1 is carved and would be carved again.</source>
            <translation>Часть слоя 1 из %1 вырезана и будет вырезана снова.</translation>
        </message>
        <message>
            <source>A program of another process runs. %1</source>
            <translation>Идёт программа другого процесса. %1</translation>
        </message>
        <message>
            <source>A program that runs keeps what it was started with</source>
            <translation>Идущая программа сохраняет то, с чем она запущена</translation>
        </message>
        <message>
            <source>A recording is being opened</source>
            <translation>Открывается запись</translation>
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
            <source>A stream</source>
            <translation>Поток</translation>
        </message>
        <message>
            <source>A table's layers and radii are taken as they stand</source>
            <translation>Слои и радиусы таблицы берутся как есть</translation>
        </message>
        <message>
            <source>A tool becomes shorter as it wears: a piece that comes out thicker on the half of %1 by so much in radius. It is counted from the head's touch-off.</source>
            <translation>Инструмент при износе становится короче: деталь на половине %1 выходит толще на столько по радиусу. Считается от касания этой головки.</translation>
        </message>
        <message>
            <source>A typed block</source>
            <translation>Введённый кадр</translation>
        </message>
        <message>
            <source>A window ended before it was published or saved. Nothing is published, nothing moves.</source>
            <translation>Окно закрылось раньше, чем это было передано или сохранено. Ничего не передаётся и не движется.</translation>
        </message>
        <message>
            <source>ACOS of a value beyond 1</source>
            <translation>ACOS значения больше 1 по модулю</translation>
        </message>
        <message>
            <source>ALARM</source>
            <translation>АВАРИЯ</translation>
        </message>
        <message>
            <source>ASIN of a value beyond 1</source>
            <translation>ASIN значения больше 1 по модулю</translation>
        </message>
        <message>
            <source>ATAN takes two values: ATAN[y]/[x]</source>
            <translation>ATAN принимает два значения: ATAN[y]/[x]</translation>
        </message>
        <message>
            <source>About Psicarve</source>
            <translation>О программе Psicarve</translation>
        </message>
        <message>
            <source>About Psicarve…</source>
            <translation>О программе Psicarve…</translation>
        </message>
        <message>
            <source>Above the blank's top there is nothing to cut: %1 of %2 layers are left out.</source>
            <translation>Выше верха заготовки резать нечего: пропущено слоёв %1 из %2.</translation>
        </message>
        <message>
            <source>Acceleration that the motor follows (a_k).</source>
            <translation>Ускорение, за которым поспевает двигатель (a_k).</translation>
        </message>
        <message>
            <source>Acknowledge</source>
            <translation>Прочитано</translation>
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
            <source>All chosen axes together; Ψ the short way. Stop and F1 end it.</source>
            <translation>Все выбранные оси вместе; Ψ кратчайшим путём. Стоп и F1 прерывают.</translation>
        </message>
        <message>
            <source>All files (*)</source>
            <translation>Все файлы (*)</translation>
        </message>
        <message>
            <source>All layers, unrolled</source>
            <translation>Все слои, развёртка</translation>
        </message>
        <message>
            <source>All round</source>
            <translation>По кругу</translation>
        </message>
        <message>
            <source>All runs</source>
            <translation>Все запуски</translation>
        </message>
        <message>
            <source>All runs: also what the cores have written down before this window was opened, in grey</source>
            <translation>Все запуски: и то, что ядра записали до открытия этого окна, серым</translation>
        </message>
        <message>
            <source>All that can be opened (%1)</source>
            <translation>Всё, что открывается (%1)</translation>
        </message>
        <message>
            <source>Allowance</source>
            <translation>Припуск</translation>
        </message>
        <message>
            <source>Angle</source>
            <translation>Угол</translation>
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
            <source>As large as the machine's travel and the blank let it be</source>
            <translation>Настолько большая, насколько позволяют ход станка и заготовка</translation>
        </message>
        <message>
            <source>As planned, at 100 % feed: bright where the heads take long</source>
            <translation>По плану, при подаче 100 %: светло там, где головки идут долго</translation>
        </message>
        <message>
            <source>As the desktop</source>
            <translation>Как в системе</translation>
        </message>
        <message>
            <source>Asked for by %1, process %2</source>
            <translation>Запросил: %1, процесс %2</translation>
        </message>
        <message>
            <source>Asked for: %1</source>
            <translation>Запрошено: %1</translation>
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
            <source>Axis: least lost</source>
            <translation>Ось: мин. потеря</translation>
        </message>
        <message>
            <source>BACKING OFF</source>
            <translation>ОТВОД</translation>
        </message>
        <message>
            <source>Back</source>
            <translation>Назад</translation>
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
            <source>Back: this is the first step</source>
            <translation>Назад: это первый шаг</translation>
        </message>
        <message>
            <source>Before</source>
            <translation>Было</translation>
        </message>
        <message>
            <source>Before its first line</source>
            <translation>Перед первой строкой</translation>
        </message>
        <message>
            <source>Before this window was there: %1</source>
            <translation>До этого окна: %1</translation>
        </message>
        <message>
            <source>Begins at</source>
            <translation>Начало</translation>
        </message>
        <message>
            <source>Begins in %1 (zero%2) with the work offsets of %3.</source>
            <translation>Начинается в %1 (ноль%2) с рабочими смещениями из %3.</translation>
        </message>
        <message>
            <source>Begins in %1 at the machine's zero, as %2 has it.</source>
            <translation>Начинается в %1, в нуле станка: так в файле %2.</translation>
        </message>
        <message>
            <source>Begins with layer 1 again; it asks first</source>
            <translation>Начинает снова со слоя 1; сначала спрашивает</translation>
        </message>
        <message>
            <source>Begun anew: none of %1 layers is finished</source>
            <translation>Начато заново: из %1 слоёв ни один не закончен</translation>
        </message>
        <message>
            <source>Begun anew: none of %1 layers of %2 is finished</source>
            <translation>Начато заново: из %1 слоёв «%2» ни один не закончен</translation>
        </message>
        <message>
            <source>Between entries</source>
            <translation>Между записями</translation>
        </message>
        <message>
            <source>Between two points of a layer the tool goes up to %1 mm too deep along its radius, into the model mostly less; more points make that less.</source>
            <translation>Между двумя точками слоя инструмент заходит по радиусу слишком глубоко, до %1 mm; в саму модель обычно меньше; при большем числе точек меньше.</translation>
        </message>
        <message>
            <source>Between two points the path may leave the straight line by this.</source>
            <translation>Между двумя точками путь может отойти от прямой на столько.</translation>
        </message>
        <message>
            <source>Black and white change places</source>
            <translation>Чёрное и белое меняются местами</translation>
        </message>
        <message>
            <source>Black, white</source>
            <translation>Чёрн., белое</translation>
        </message>
        <message>
            <source>Blank</source>
            <translation>Заготовка</translation>
        </message>
        <message>
            <source>Blank height</source>
            <translation>H заготовки</translation>
        </message>
        <message>
            <source>Blank in the way?</source>
            <translation>Заготовка мешает?</translation>
        </message>
        <message>
            <source>Blank matches job</source>
            <translation>Заготовка подходит</translation>
        </message>
        <message>
            <source>Blank off, 0°</source>
            <translation>Смещение, 0°</translation>
        </message>
        <message>
            <source>Blank off, 90°</source>
            <translation>Смещение, 90°</translation>
        </message>
        <message>
            <source>Blank radius</source>
            <translation>R заготовки</translation>
        </message>
        <message>
            <source>Block asked for: %1</source>
            <translation>Запрошен кадр: %1</translation>
        </message>
        <message>
            <source>Block delete</source>
            <translation>Пропуск кадров</translation>
        </message>
        <message>
            <source>Bodies</source>
            <translation>Тела</translation>
        </message>
        <message>
            <source>Both heads go out to the end of their travel.</source>
            <translation>Обе головки отходят наружу до конца хода.</translation>
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
            <source>Bound by</source>
            <translation>Предел</translation>
        </message>
        <message>
            <source>Bounds</source>
            <translation>Пределы</translation>
        </message>
        <message>
            <source>Brightness to this power</source>
            <translation>Яркость в этой степени</translation>
        </message>
        <message>
            <source>Built-in profile</source>
            <translation>Встроенный профиль</translation>
        </message>
        <message>
            <source>By feed and top speeds alone; acceleration takes longer</source>
            <translation>Только по подаче и предельным скоростям; разгон добавит времени</translation>
        </message>
        <message>
            <source>By feed and top speeds alone; it is planned while the machine is at rest</source>
            <translation>Только по подаче и предельным скоростям; план считается, пока станок стоит</translation>
        </message>
        <message>
            <source>By hand</source>
            <translation>Вручную</translation>
        </message>
        <message>
            <source>By hand; a job does it by itself, and Stop switches it off</source>
            <translation>Вручную; задание делает это само, а Стоп выключает</translation>
        </message>
        <message>
            <source>By mouse, or with Ctrl+−, Ctrl++ and Ctrl+0</source>
            <translation>Мышью или клавишами Ctrl+−, Ctrl++ и Ctrl+0</translation>
        </message>
        <message>
            <source>CARVING</source>
            <translation>РЕЗЬБА</translation>
        </message>
        <message>
            <source>Calibrate</source>
            <translation>Калибровка</translation>
        </message>
        <message>
            <source>Calibrate the heads</source>
            <translation>Калибровка головок</translation>
        </message>
        <message>
            <source>Calibrate the heads…</source>
            <translation>Калибровка головок…</translation>
        </message>
        <message>
            <source>Calibrate: a value of the profile is wrong</source>
            <translation>Калибровка: в профиле есть неверное значение</translation>
        </message>
        <message>
            <source>Calibrate: open the machine's profile first, or save this one as a file</source>
            <translation>Калибровка: сначала откройте профиль станка или сохраните этот в файл</translation>
        </message>
        <message>
            <source>Calibrate: save the profile first, or undo what was changed</source>
            <translation>Калибровка: сначала сохраните профиль или отмените изменения</translation>
        </message>
        <message>
            <source>Calibrate…</source>
            <translation>Калибровка…</translation>
        </message>
        <message>
            <source>Calibration written: %1; the old profile is %2</source>
            <translation>Калибровка записана: %1; старый профиль — %2</translation>
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
            <source>Cancel verification</source>
            <translation>Отменить сверку</translation>
        </message>
        <message>
            <source>Cancel: nothing is being read</source>
            <translation>Отмена: ничего не читается</translation>
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
            <source>Carves from the point where the heads wait (Ctrl+Enter)</source>
            <translation>Режет с точки, где ждут головки (Ctrl+Enter)</translation>
        </message>
        <message>
            <source>Carves the begun layer once more from its begin</source>
            <translation>Вырезает начатый слой ещё раз с его начала</translation>
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
            <source>Carving began with layer %2, point %3: %1</source>
            <translation>Резьба началась со слоя %2, точка %3: %1</translation>
        </message>
        <message>
            <source>Carving began with layer %2: %1</source>
            <translation>Резьба началась со слоя %2: %1</translation>
        </message>
        <message>
            <source>Carving time</source>
            <translation>Время резьбы</translation>
        </message>
        <message>
            <source>Centre of the arc</source>
            <translation>Центр дуги</translation>
        </message>
        <message>
            <source>Centre of the arc, %1</source>
            <translation>Центр дуги, %1</translation>
        </message>
        <message>
            <source>Changed</source>
            <translation>Изменённые</translation>
        </message>
        <message>
            <source>Changed since it was sliced: slice again to take it over.</source>
            <translation>Изменено после нарезки: нарежьте заново, чтобы учесть.</translation>
        </message>
        <message>
            <source>Changes that, and slices again</source>
            <translation>Меняет это и нарезает снова</translation>
        </message>
        <message>
            <source>Charge pump</source>
            <translation>Charge pump (генератор накачки)</translation>
        </message>
        <message>
            <source>Check the axis' home sensor, its wire and its pin in the profile; reset the alarm, then home again.</source>
            <translation>Проверьте датчик нуля оси, его провод и вывод в профиле; сбросьте аварию, затем снова найдите нули.</translation>
        </message>
        <message>
            <source>Check the port's card, cable and driver; once it answers again, reset the alarm, then home.</source>
            <translation>Проверьте плату порта, кабель и драйвер; когда порт снова ответит, сбросьте аварию, затем найдите нули.</translation>
        </message>
        <message>
            <source>Check the sensor of axis %1</source>
            <translation>Проверьте датчик оси %1</translation>
        </message>
        <message>
            <source>Check this computer</source>
            <translation>Проверить компьютер</translation>
        </message>
        <message>
            <source>Choose a file...</source>
            <translation>Выбрать файл...</translation>
        </message>
        <message>
            <source>Circumference of the cylinder, mm</source>
            <translation>Длина окружности цилиндра, mm</translation>
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
            <source>Closed: %1, neither published nor saved</source>
            <translation>Закрыто: %1 — не опубликовано и не сохранено</translation>
        </message>
        <message>
            <source>Column %1: %2</source>
            <translation>Столбец %1: %2</translation>
        </message>
        <message>
            <source>Command</source>
            <translation>Команда</translation>
        </message>
        <message>
            <source>Command: %1</source>
            <translation>Команда: %1</translation>
        </message>
        <message>
            <source>Command: %1 (%2)</source>
            <translation>Команда: %1 (%2)</translation>
        </message>
        <message>
            <source>Commands</source>
            <translation>Команды</translation>
        </message>
        <message>
            <source>Compare</source>
            <translation>Сравнить</translation>
        </message>
        <message>
            <source>Compare two snapshots…</source>
            <translation>Сравнить два снимка…</translation>
        </message>
        <message>
            <source>Compare with defaults</source>
            <translation>Сравнить с исходным</translation>
        </message>
        <message>
            <source>Comparison</source>
            <translation>Сравнение</translation>
        </message>
        <message>
            <source>Confirm and start</source>
            <translation>Подтвердить и пустить</translation>
        </message>
        <message>
            <source>Continue from layer %1</source>
            <translation>Продолжить со слоя %1</translation>
        </message>
        <message>
            <source>Continue from layer %1, point %2</source>
            <translation>Далее: слой %1, точка %2</translation>
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
            <source>Core: profile %1, not %2</source>
            <translation>Ядро: профиль %1, а не %2</translation>
        </message>
        <message>
            <source>Cutting end of the tools; jobs keep all of it out of the model. A point has no size.</source>
            <translation>Режущий конец инструментов; задание не пускает его в модель целиком. У point нет размера.</translation>
        </message>
        <message>
            <source>DRY RUN</source>
            <translation>ХОЛОСТОЙ</translation>
        </message>
        <message>
            <source>Damaged or torn records of the machine's history are left out: %1</source>
            <translation>Повреждённые записи истории станка опущены: %1</translation>
        </message>
        <message>
            <source>Dark</source>
            <translation>Тёмная</translation>
        </message>
        <message>
            <source>Decode</source>
            <translation>Разобрать</translation>
        </message>
        <message>
            <source>Decode: no program is open</source>
            <translation>Разобрать: программа не открыта</translation>
        </message>
        <message>
            <source>Default</source>
            <translation>Исходное</translation>
        </message>
        <message>
            <source>Depth</source>
            <translation>Глубина</translation>
        </message>
        <message>
            <source>Depth limit</source>
            <translation>Предел глубины</translation>
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
            <source>Diameter</source>
            <translation>Диаметр</translation>
        </message>
        <message>
            <source>Diameter of the blank</source>
            <translation>Диаметр заготовки</translation>
        </message>
        <message>
            <source>Diameter of the cylinder, mm</source>
            <translation>Диаметр цилиндра, mm</translation>
        </message>
        <message>
            <source>Diameter of the pin</source>
            <translation>Диаметр штифта</translation>
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
            <source>Dismiss</source>
            <translation>Убрать</translation>
        </message>
        <message>
            <source>Done</source>
            <translation>Готовое</translation>
        </message>
        <message>
            <source>Draft, of samples of the model: tips are kept %1 mm further out</source>
            <translation>Набросок по точкам модели: остриё держится на %1 mm дальше</translation>
        </message>
        <message>
            <source>Drawings (%1)</source>
            <translation>Чертежи (%1)</translation>
        </message>
        <message>
            <source>Drives and spindle are off; the position is not certain any more.</source>
            <translation>Приводы и шпиндель выключены; положение больше не достоверно.</translation>
        </message>
        <message>
            <source>Drives and spindle may still be on, and nothing here can switch them off.</source>
            <translation>Приводы и шпиндель могут быть ещё включены, и отсюда их не выключить.</translation>
        </message>
        <message>
            <source>Drives and spindle may still be on: the port has not taken the order to switch them off. It is repeated until it does.</source>
            <translation>Приводы и шпиндель могут быть ещё включены: порт не принял команду их выключить. Она повторяется, пока порт её не примет.</translation>
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
            <source>Dry run</source>
            <translation>Холостой прогон</translation>
        </message>
        <message>
            <source>Dry run began with layer %2, point %3: %1</source>
            <translation>Холостой прогон начался со слоя %2, точка %3: %1</translation>
        </message>
        <message>
            <source>Dry run began with layer %2: %1</source>
            <translation>Холостой прогон начался со слоя %2: %1</translation>
        </message>
        <message>
            <source>Dry run from layer %1, point %2: the heads go out and stay there, spindle off; table and Y go as they would from there.</source>
            <translation>Холостой прогон со слоя %1, точка %2: головки выходят и остаются снаружи, шпиндель выключен; стол и Y движутся оттуда как при резьбе.</translation>
        </message>
        <message>
            <source>Dry run from layer %1: the heads go out and stay there, spindle off; Y goes to the layer, then table and Y go as they would.</source>
            <translation>Холостой прогон со слоя %1: головки выходят и остаются снаружи, шпиндель выключен; Y идёт к слою, затем стол и Y движутся как при резьбе.</translation>
        </message>
        <message>
            <source>Dry run from layer 1: the heads go out and stay there, spindle off; table and Y go as they would. Nothing is cut, and where the piece goes on stays known.</source>
            <translation>Холостой прогон со слоя 1: головки выходят и остаются снаружи, шпиндель выключен; стол и Y движутся как при резьбе. Ничего не режется, и место, откуда продолжать деталь, остаётся известным.</translation>
        </message>
        <message>
            <source>Dry run, layer %1 of %2</source>
            <translation>Холостой, слой %1 из %2</translation>
        </message>
        <message>
            <source>Dry run: at its beginning</source>
            <translation>Холостой: у начала</translation>
        </message>
        <message>
            <source>Dry run: to its beginning</source>
            <translation>Холостой: к началу</translation>
        </message>
        <message>
            <source>E-stop</source>
            <translation>Авар.</translation>
        </message>
        <message>
            <source>EMERGENCY STOP</source>
            <translation>АВАРИЙНЫЙ
ОСТАНОВ (F1)</translation>
        </message>
        <message>
            <source>EXISTS asks for a parameter</source>
            <translation>EXISTS спрашивает о параметре</translation>
        </message>
        <message>
            <source>EXISTS[ has no ]</source>
            <translation>у EXISTS[ нет ]</translation>
        </message>
        <message>
            <source>Each block is a program of its own: G21 G17 G90 G94 G54 G80 hold before it, without a feed, and the spindle is off behind it.</source>
            <translation>Каждый кадр — отдельная программа: перед ним действуют G21 G17 G90 G94 G54 G80, подача не задана, после него шпиндель выключен.</translation>
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
            <source>Emitted since Start: the ways in and out, and back from a hold, as well</source>
            <translation>Выданы после пуска: вместе с подходом, отходом и возвратом после паузы</translation>
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
            <source>End now</source>
            <translation>Закончить</translation>
        </message>
        <message>
            <source>End now: nothing is being measured</source>
            <translation>Закончить: измерение не идёт</translation>
        </message>
        <message>
            <source>End psicarve-rtcore, process %1</source>
            <translation>Завершите psicarve-rtcore, процесс %1</translation>
        </message>
        <message>
            <source>Ends the job or program: heads out, spindle off (Shift+Esc)</source>
            <translation>Завершает задание или программу: головки наружу, шпиндель выключен (Shift+Esc)</translation>
        </message>
        <message>
            <source>Ends the program in order: heads out, spindle off (Shift+Esc)</source>
            <translation>Завершает программу по порядку: головки наружу, шпиндель выключен (Shift+Esc)</translation>
        </message>
        <message>
            <source>English</source>
            <translation>Русский</translation>
        </message>
        <message>
            <source>Engrave its lines</source>
            <translation>Гравировать линии</translation>
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
            <source>Even with a height of its own; else the picture keeps its shape and the rest stays white</source>
            <translation>Даже при заданной высоте; иначе изображение сохраняет пропорции, а остальное остаётся белым</translation>
        </message>
        <message>
            <source>Every edge of every pin into a file, from here on; a job that is carved whole meanwhile is verified</source>
            <translation>С этого момента каждый фронт каждого вывода в файл; целиком вырезанное задание сверяется</translation>
        </message>
        <message>
            <source>Every pulse</source>
            <translation>Импульсы</translation>
        </message>
        <message>
            <source>Expected piece</source>
            <translation>Ожидаемая деталь</translation>
        </message>
        <message>
            <source>F is along X, Y and Z, or of the faster tool over the piece, which turns under it.</source>
            <translation>F — скорость вдоль X, Y и Z или скорость более быстрого инструмента по детали, которая под ним вращается.</translation>
        </message>
        <message>
            <source>F stands beside new units, and counts in these</source>
            <translation>F стоит рядом со сменой единиц и считается в новых</translation>
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
            <translation>F1  аварийный останов, везде
Shift+Esc  стоп, везде
Esc  пауза; в диалоге или меню: закрыть
Ctrl+Enter  пуск
Pause  пауза, продолжить, везде
Ctrl+Home  поиск нуля всех осей
Ctrl+0, Ctrl+−, Ctrl++  коррекция подачи
Ctrl+O  открыть
F5  нарезать
F9  включить перемещение с клавиатуры
Ctrl+1 … 8  вкладки
Ctrl+L  номер слоя
F6  следующая панель
F10  меню
F12  этот список</translation>
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
            <source>Feeds along a path through all points, or, of a head and Y, by point-by-point comparison.</source>
            <translation>Подачи идут по траектории через все точки или, для одной головки и Y, методом поточечного сравнения.</translation>
        </message>
        <message>
            <source>File</source>
            <translation>Файл</translation>
        </message>
        <message>
            <source>Find a key</source>
            <translation>Найти ключ</translation>
        </message>
        <message>
            <source>First Home all.</source>
            <translation>Сначала «Все нули».</translation>
        </message>
        <message>
            <source>First Home all: %1 are not homed.</source>
            <translation>Сначала «Все нули»: не найдены нули %1.</translation>
        </message>
        <message>
            <source>First Home all: the drives are off.</source>
            <translation>Сначала «Все нули»: приводы отключены.</translation>
        </message>
        <message>
            <source>First difference</source>
            <translation>Первое отличие</translation>
        </message>
        <message>
            <source>First snapshot or job</source>
            <translation>Первый снимок или задание</translation>
        </message>
        <message>
            <source>First start psicarve-rtcore, then Home all.</source>
            <translation>Сначала запустите psicarve-rtcore, затем «Все нули».</translation>
        </message>
        <message>
            <source>First start psicarve-rtcore.</source>
            <translation>Сначала запустите psicarve-rtcore.</translation>
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
            <source>Flood</source>
            <translation>Подача СОЖ</translation>
        </message>
        <message>
            <source>Flute length</source>
            <translation>Режущая длина</translation>
        </message>
        <message>
            <source>Folder for the support bundle</source>
            <translation>Папка для пакета поддержки</translation>
        </message>
        <message>
            <source>Follow the line</source>
            <translation>Следить за строкой</translation>
        </message>
        <message>
            <source>Follow the machine</source>
            <translation>Следить за станком</translation>
        </message>
        <message>
            <source>Follow the machine: it does not carve this job</source>
            <translation>Следить за станком: он режет не это задание</translation>
        </message>
        <message>
            <source>Forget</source>
            <translation>Забыть</translation>
        </message>
        <message>
            <source>Forget it</source>
            <translation>Забыть</translation>
        </message>
        <message>
            <source>Forget this piece</source>
            <translation>Забыть эту деталь</translation>
        </message>
        <message>
            <source>Forget this piece…</source>
            <translation>Забыть эту деталь…</translation>
        </message>
        <message>
            <source>Forgets for good how far this piece is carved; it asks first and moves nothing</source>
            <translation>Навсегда забывает, докуда вырезана эта деталь; сначала спрашивает, ничего не двигает</translation>
        </message>
        <message>
            <source>Forgets the zero of %1</source>
            <translation>Забывает отсчёт %1</translation>
        </message>
        <message>
            <source>Forget…</source>
            <translation>Забыть…</translation>
        </message>
        <message>
            <source>Found</source>
            <translation>Найдено</translation>
        </message>
        <message>
            <source>From R1's mark to R2's, counter-clockwise from above is +</source>
            <translation>От метки R1 до метки R2, против часовой сверху — плюс</translation>
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
            <source>From line</source>
            <translation>Со строки</translation>
        </message>
        <message>
            <source>From now on</source>
            <translation>Станет</translation>
        </message>
        <message>
            <source>From point to point as the job's tables have it</source>
            <translation>От точки к точке по таблицам задания</translation>
        </message>
        <message>
            <source>From the flight recorder. A click goes to an entry.</source>
            <translation>Из самописца. Щелчок ведёт к записи.</translation>
        </message>
        <message>
            <source>From where most of the undercut is seen</source>
            <translation>Откуда видна большая часть поднутрения</translation>
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
            <source>G-code</source>
            <translation>G-код</translation>
        </message>
        <message>
            <source>G0 of C turns as it is written, or the shortest way to the same direction.</source>
            <translation>G0 оси C поворачивает, как написано, или кратчайшим путём к тому же направлению.</translation>
        </message>
        <message>
            <source>G10 L20 sets no rotation</source>
            <translation>G10 L20 не задаёт поворота</translation>
        </message>
        <message>
            <source>G10 has no L</source>
            <translation>у G10 нет L</translation>
        </message>
        <message>
            <source>G10 has no P, the system</source>
            <translation>у G10 нет P, номера системы</translation>
        </message>
        <message>
            <source>G10 is read with L2 and L20</source>
            <translation>G10 читается с L2 и L20</translation>
        </message>
        <message>
            <source>G12.1 with the tip %1 mm from the axis, and there is no direction</source>
            <translation>G12.1, а остриё в %1 mm от оси, и направления нет</translation>
        </message>
        <message>
            <source>G12.1, and X 0 lies %1 mm off the axis</source>
            <translation>G12.1, а X 0 лежит в %1 mm от оси</translation>
        </message>
        <message>
            <source>G12.1, and the program has not said yet where X and C are</source>
            <translation>G12.1, а программа ещё не сказала, где X и C</translation>
        </message>
        <message>
            <source>G12.1, and the tip of r2, which follows, stands %1 mm further in</source>
            <translation>G12.1, а остриё ведомой r2 стоит на %1 mm ближе к оси</translation>
        </message>
        <message>
            <source>G12.1, and the tip of r2, which follows, stands %1 mm further out</source>
            <translation>G12.1, а остриё ведомой r2 стоит на %1 mm дальше от оси</translation>
        </message>
        <message>
            <source>G4 has no P, the seconds</source>
            <translation>у G4 нет P, секунд</translation>
        </message>
        <message>
            <source>G53 while G91 holds</source>
            <translation>G53 при действующем G91</translation>
        </message>
        <message>
            <source>G53 without a straight motion</source>
            <translation>G53 без прямолинейного перемещения</translation>
        </message>
        <message>
            <source>G64 P of %1 mm; the machine can have %2 to %3 mm</source>
            <translation>P в G64 — %1 mm; станок может от %2 до %3 mm</translation>
        </message>
        <message>
            <source>G7.1 has no C, the cylinder's radius</source>
            <translation>у G7.1 нет C, радиуса цилиндра</translation>
        </message>
        <message>
            <source>Gamma, smooth</source>
            <translation>Гамма, сглаж.</translation>
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
            <source>Go</source>
            <translation>Пуск</translation>
        </message>
        <message>
            <source>Go on with an unfinished piece</source>
            <translation>Продолжить незаконченную деталь</translation>
        </message>
        <message>
            <source>Go to</source>
            <translation>Переход</translation>
        </message>
        <message>
            <source>Go to: an arc is of one head and Y</source>
            <translation>Переход: дуга — только одна головка и Y</translation>
        </message>
        <message>
            <source>Go to: choose an axis</source>
            <translation>Переход: выберите ось</translation>
        </message>
        <message>
            <source>Go to: two axes at most, step by step</source>
            <translation>Переход: по шагам не более двух осей</translation>
        </message>
        <message>
            <source>Go to: Ψ moves in straight lines only</source>
            <translation>Переход: Ψ движется только по прямой</translation>
        </message>
        <message>
            <source>Go to…</source>
            <translation>Перейти…</translation>
        </message>
        <message>
            <source>Goes on where it stands (Pause)</source>
            <translation>Продолжает с места остановки (Pause)</translation>
        </message>
        <message>
            <source>Greatest difference at an index pass that is not the alarm steps lost.</source>
            <translation>Наибольшее расхождение на проходе нуля, ещё не вызывающее аварию «потеря шагов».</translation>
        </message>
        <message>
            <source>Grooves are as wide as the strokes of an SVG drawing, at least as the tool</source>
            <translation>Канавки шириной с линии SVG, не уже инструмента</translation>
        </message>
        <message>
            <source>Grooves end at the core radius of %1 mm, less deep than asked.</source>
            <translation>Канавки кончаются у радиуса сердцевины %1 mm, мельче заданного.</translation>
        </message>
        <message>
            <source>Grooves of the tool's width in a cylinder, instead of an extruded outline</source>
            <translation>Канавки шириной с инструмент на цилиндре вместо вытянутого контура</translation>
        </message>
        <message>
            <source>HELD</source>
            <translation>ПАУЗА</translation>
        </message>
        <message>
            <source>HOLDING</source>
            <translation>К ПАУЗЕ</translation>
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
            <source>Head clearance</source>
            <translation>Зазор головок</translation>
        </message>
        <message>
            <source>Heads move out this far after the last point, on stop, and on hold if on_hold says so.</source>
            <translation>На столько головки отходят после последней точки, при остановке, а также в паузе, если так задано в on_hold.</translation>
        </message>
        <message>
            <source>Heads out, spindle off</source>
            <translation>Отвод головок, шпиндель выкл.</translation>
        </message>
        <message>
            <source>Heads out, to point %2 of layer %1, then carve what is left (Ctrl+Enter)</source>
            <translation>Головки наружу, к точке %2 слоя %1, затем резать остальное (Ctrl+Enter)</translation>
        </message>
        <message>
            <source>Heads out, to the first point of layer %1, then carve what is left (Ctrl+Enter)</source>
            <translation>Головки наружу, к первой точке слоя %1, затем резать остальное (Ctrl+Enter)</translation>
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
            <source>Height %1 mm</source>
            <translation>Высота %1 mm</translation>
        </message>
        <message>
            <source>Height sets it</source>
            <translation>Задано высотой</translation>
        </message>
        <message>
            <source>Height, radius</source>
            <translation>Высота, радиус</translation>
        </message>
        <message>
            <source>Help</source>
            <translation>Справка</translation>
        </message>
        <message>
            <source>Here</source>
            <translation>Здесь</translation>
        </message>
        <message>
            <source>Here: no profile is open</source>
            <translation>Здесь: профиль не открыт</translation>
        </message>
        <message>
            <source>Hold</source>
            <translation>Пауза</translation>
        </message>
        <message>
            <source>Hold = move, click = one step.</source>
            <translation>Держать = ход, щелчок = один шаг.</translation>
        </message>
        <message>
            <source>Hold asked for by Esc: Resume or the Pause key goes on</source>
            <translation>Пауза по Esc: продолжить — кнопкой «Продолжить» или клавишей Pause</translation>
        </message>
        <message>
            <source>Hold asked for: the window closes once the core has taken it</source>
            <translation>Запрошена пауза: окно закроется, когда ядро её примет</translation>
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
            <source>Holds at M1</source>
            <translation>Останавливается на M1</translation>
        </message>
        <message>
            <source>Holds behind each block; Resume goes on</source>
            <translation>Пауза после каждого кадра; «Продолжить» ведёт дальше</translation>
        </message>
        <message>
            <source>Holds every pulse against the job</source>
            <translation>Сверяет каждый импульс с заданием</translation>
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
            <source>Home before carving</source>
            <translation>Перед резьбой найдите ноль</translation>
        </message>
        <message>
            <source>Home Ψ: home R1 and R2 first</source>
            <translation>Ноль Ψ: сначала найдите нули R1 и R2</translation>
        </message>
        <message>
            <source>Homed</source>
            <translation>Ноль найден</translation>
        </message>
        <message>
            <source>Homed, job published</source>
            <translation>Нули найдены, задание есть</translation>
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
            <source>How deep black lies, mm</source>
            <translation>Глубина чёрного, mm</translation>
        </message>
        <message>
            <source>How deep the grooves are</source>
            <translation>Глубина канавок</translation>
        </message>
        <message>
            <source>How deep the tool can cut</source>
            <translation>Насколько глубоко режет инструмент</translation>
        </message>
        <message>
            <source>How deep the tool can cut; 0: deeper than any cut.</source>
            <translation>На какую глубину режет инструмент; 0: глубже любого реза.</translation>
        </message>
        <message>
            <source>How deep white lies, mm</source>
            <translation>Глубина белого, mm</translation>
        </message>
        <message>
            <source>How far past the sensor the mechanics allow.</source>
            <translation>На сколько механика допускает ход за датчик.</translation>
        </message>
        <message>
            <source>How far the unfinished piece is carved is forgotten for good, and with it the core's copy of its job. Nothing moves.</source>
            <translation>Навсегда забывается, докуда вырезана незаконченная деталь, а с этим и копия её задания у ядра. Ничего не двигается.</translation>
        </message>
        <message>
            <source>How late the core's ticks would be, beside whatever the computer does</source>
            <translation>Насколько опаздывали бы такты ядра рядом с прочими делами компьютера</translation>
        </message>
        <message>
            <source>How late ticks were: number of ticks by lateness</source>
            <translation>Насколько запаздывали такты: число тактов по запаздыванию</translation>
        </message>
        <message>
            <source>How long to measure</source>
            <translation>Сколько измерять</translation>
        </message>
        <message>
            <source>How many pulses</source>
            <translation>Сколько импульсов</translation>
        </message>
        <message>
            <source>How much further in each roughing pass goes</source>
            <translation>На сколько глубже идёт каждый черновой проход</translation>
        </message>
        <message>
            <source>How much further in each roughing pass goes; 0: the finishing pass alone.</source>
            <translation>На сколько глубже идёт каждый черновой проход; 0: только чистовой проход.</translation>
        </message>
        <message>
            <source>How much higher R2 stands than R1, measured once.</source>
            <translation>На сколько R2 стоит выше R1, измеряется однажды.</translation>
        </message>
        <message>
            <source>How much higher R2's mark is, lower is −</source>
            <translation>Насколько метка R2 выше, ниже — минус</translation>
        </message>
        <message>
            <source>How the one before ended is not known</source>
            <translation>Как завершилось предыдущее, не известно</translation>
        </message>
        <message>
            <source>How to go there</source>
            <translation>Способ перехода</translation>
        </message>
        <message>
            <source>Hundreds of roughing passes</source>
            <translation>Сотни черновых проходов</translation>
        </message>
        <message>
            <source>IDLE</source>
            <translation>ОЖИДАНИЕ</translation>
        </message>
        <message>
            <source>INSERT of a block that is not there is left out.</source>
            <translation>INSERT несуществующего блока пропущен.</translation>
        </message>
        <message>
            <source>INSERT of a block that is not there or holds itself is left out.</source>
            <translation>INSERT блока, которого нет или который содержит сам себя, пропущен.</translation>
        </message>
        <message>
            <source>If anything still moves, use the wired emergency stop</source>
            <translation>Если что-то ещё движется, нажмите проводной аварийный останов</translation>
        </message>
        <message>
            <source>If the power fails, do not go on by it; see to the disk.</source>
            <translation>Если пропадёт питание, не продолжайте по этим данным; проверьте диск.</translation>
        </message>
        <message>
            <source>In the file</source>
            <translation>В файле</translation>
        </message>
        <message>
            <source>In the file: %1</source>
            <translation>В файле: %1</translation>
        </message>
        <message>
            <source>In the lowest layer the tool reaches %1 mm below the table's top: the table must be narrower than the job, or base_height_mm more.</source>
            <translation>В нижнем слое инструмент опускается на %1 mm ниже верха стола: стол должен быть уже задания, или увеличьте base_height_mm.</translation>
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
            <source>Information</source>
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
            <source>Invert</source>
            <translation>Негатив</translation>
        </message>
        <message>
            <source>Is the disk full, or the folder another user's?</source>
            <translation>Диск заполнен, или папка принадлежит другому пользователю?</translation>
        </message>
        <message>
            <source>Iso</source>
            <translation>Изометрия</translation>
        </message>
        <message>
            <source>It ended in layer %1, point %2.</source>
            <translation>Обработка прервалась в слое %1, точка %2.</translation>
        </message>
        <message>
            <source>It is not offered again; the file stays</source>
            <translation>Больше не предлагается; файл остаётся</translation>
        </message>
        <message>
            <source>It is the first one</source>
            <translation>Оно первое</translation>
        </message>
        <message>
            <source>It was begun with another profile of the machine.</source>
            <translation>Она начата с другим профилем станка.</translation>
        </message>
        <message>
            <source>Its core is gone, and its flight recorder with it</source>
            <translation>Её ядра больше нет, а с ним и самописца</translation>
        </message>
        <message>
            <source>Its guard could not switch drives and spindle off: the port does not answer.</source>
            <translation>Его сторож не смог выключить приводы и шпиндель: порт не отвечает.</translation>
        </message>
        <message>
            <source>Its guard has switched drives and spindle off.</source>
            <translation>Его сторож выключил приводы и шпиндель.</translation>
        </message>
        <message>
            <source>Its line at the end</source>
            <translation>Её строка в конце</translation>
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
            <source>Job done: %1</source>
            <translation>Задание выполнено: %1</translation>
        </message>
        <message>
            <source>Job ended by an alarm in layer %2: %1</source>
            <translation>Задание прервано аварией в слое %2: %1</translation>
        </message>
        <message>
            <source>Job in the machine</source>
            <translation>Задание в станке</translation>
        </message>
        <message>
            <source>Job in travel</source>
            <translation>Ход достаточен</translation>
        </message>
        <message>
            <source>Job loaded: %1, %2 layers of %3 points</source>
            <translation>Задание загружено: %1, слоёв: %2, точек в слое: %3</translation>
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
            <source>Job refused</source>
            <translation>Задание отклонено</translation>
        </message>
        <message>
            <source>Job stopped in layer %2: %1</source>
            <translation>Задание остановлено в слое %2: %1</translation>
        </message>
        <message>
            <source>Job, state and flight recorder of the machine, to be looked at later</source>
            <translation>Задание, состояние и самописец станка для просмотра позже</translation>
        </message>
        <message>
            <source>Job: %1 × %2 points</source>
            <translation>Задание: %1 × %2 точек</translation>
        </message>
        <message>
            <source>Jobs (%1)</source>
            <translation>Задания (%1)</translation>
        </message>
        <message>
            <source>Jobs (*.job *.psi)</source>
            <translation>Задания (*.job *.psi)</translation>
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
            <translation>Ручной ход: нули не найдены</translation>
        </message>
        <message>
            <source>Jogging</source>
            <translation>Ручной ход</translation>
        </message>
        <message>
            <source>Joining</source>
            <translation>Связь слоёв</translation>
        </message>
        <message>
            <source>Judged</source>
            <translation>Проверено</translation>
        </message>
        <message>
            <source>Judged by the job that is open</source>
            <translation>Проверено по открытому заданию</translation>
        </message>
        <message>
            <source>Judged by the job that the trace carries</source>
            <translation>Проверено по заданию, записанному в трассе</translation>
        </message>
        <message>
            <source>Judged up to</source>
            <translation>Проверено до</translation>
        </message>
        <message>
            <source>K  play, pause
J, L  slower, faster
N, Shift+N  next entry, entry before
,  .  one layer
Arrows, PgUp, PgDn, Home, End  on the timeline</source>
            <translation>K  пуск, пауза
J, L  медленнее, быстрее
N, Shift+N  следующая, предыдущая запись
,  .  один слой
Стрелки, PgUp, PgDn, Home, End  по шкале времени</translation>
        </message>
        <message>
            <source>Keeps the line that runs in sight</source>
            <translation>Держит исполняемую строку на виду</translation>
        </message>
        <message>
            <source>Key</source>
            <translation>Ключ</translation>
        </message>
        <message>
            <source>Keys</source>
            <translation>Клавиши</translation>
        </message>
        <message>
            <source>Keys move the machine; F9 ends it.</source>
            <translation>Клавиши двигают станок; F9 — конец.</translation>
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
            <source>L of M66 is 0 to 4</source>
            <translation>L в M66 — от 0 до 4</translation>
        </message>
        <message>
            <source>L of M66 is a way to wait</source>
            <translation>L в M66 — способ ожидания</translation>
        </message>
        <message>
            <source>LN of a value that is not above 0</source>
            <translation>LN значения, которое не больше 0</translation>
        </message>
        <message>
            <source>Language</source>
            <translation>Язык</translation>
        </message>
        <message>
            <source>Largest</source>
            <translation>Наибольшая</translation>
        </message>
        <message>
            <source>Largest deviation</source>
            <translation>Наибольшее отклонение</translation>
        </message>
        <message>
            <source>Largest sets it</source>
            <translation>Задано выбором «Наибольшая»</translation>
        </message>
        <message>
            <source>Last good layer: %1.</source>
            <translation>Последний хороший слой: %1.</translation>
        </message>
        <message>
            <source>Last good: layer %1, to its point %2.</source>
            <translation>Последний хороший: слой %1, до точки %2.</translation>
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
            <source>Layer %1 / %2 · point %3 / %4 · elapsed %5 · override %6 %</source>
            <translation>Слой %1 / %2 · точка %3 / %4 · прошло %5 · коррекция %6 %</translation>
        </message>
        <message>
            <source>Layer %1 / %2, point %3 / %4</source>
            <translation>Слой %1 / %2, точка %3 / %4</translation>
        </message>
        <message>
            <source>Layer %1 can be wrong%2</source>
            <translation>Слой %1 может быть неверным%2</translation>
        </message>
        <message>
            <source>Layer %1 of %2</source>
            <translation>Слой %1 из %2</translation>
        </message>
        <message>
            <source>Layer %1 was the last that was finished.</source>
            <translation>Последний завершённый слой — %1.</translation>
        </message>
        <message>
            <source>Layer 1 of %1 is carved and would be carved again.</source>
            <translation>Слой 1 из %1 вырезан и будет вырезан снова.</translation>
        </message>
        <message>
            <source>Layer and point are those of the machine, until others are chosen</source>
            <translation>Слой и точка как у станка, пока не выбраны другие</translation>
        </message>
        <message>
            <source>Layer time</source>
            <translation>Время слоя</translation>
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
            <source>Layers %1 to %2 can be wrong%3</source>
            <translation>Слои с %1 по %2 могут быть неверными%3</translation>
        </message>
        <message>
            <source>Layers 1 to %1 of %2 are carved and would be carved again.</source>
            <translation>Слои с 1 по %1 из %2 вырезаны и будут вырезаны снова.</translation>
        </message>
        <message>
            <source>Layers and points lie farther from each other than the tool cuts, %1 mm: choose more of them.</source>
            <translation>Слои и точки дальше друг от друга, чем режет инструмент (%1 mm): задайте их больше.</translation>
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
            <source>Leaves out blocks that begin with /</source>
            <translation>Пропускает кадры, начинающиеся с /</translation>
        </message>
        <message>
            <source>Leaves out the layers before it</source>
            <translation>Пропускает слои до него</translation>
        </message>
        <message>
            <source>Leaves out the layers before it; %1 was the last that was finished</source>
            <translation>Пропускает слои до него; последний завершённый — %1</translation>
        </message>
        <message>
            <source>Leaves replay and opens the job in this snapshot</source>
            <translation>Закрывает воспроизведение и открывает задание из снимка</translation>
        </message>
        <message>
            <source>Left out, as they are no lines: %1.</source>
            <translation>Пропущено, так как это не линии: %1.</translation>
        </message>
        <message>
            <source>Left over %1 mm at most, at %2°, %3 mm high; %4 mm on average</source>
            <translation>Остаётся не более %1 mm, при %2° на высоте %3 mm; в среднем %4 mm</translation>
        </message>
        <message>
            <source>Letters for R1, R2, Y and Psi: X, Z, Y and C, or, as lathes have them, X, U, Z and C.</source>
            <translation>Буквы осей R1, R2, Y и Psi: X, Z, Y и C или, как у токарных станков, X, U, Z и C.</translation>
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
            <source>Line %1</source>
            <translation>Строка %1</translation>
        </message>
        <message>
            <source>Line %1, column %2</source>
            <translation>Строка %1, столбец %2</translation>
        </message>
        <message>
            <source>Line to begin with</source>
            <translation>Строка, с которой начать</translation>
        </message>
        <message>
            <source>Lines: %1, moves: %2, errors: %3, warnings: %4</source>
            <translation>Строк: %1, перемещений: %2, ошибок: %3, предупреждений: %4</translation>
        </message>
        <message>
            <source>Live machine: %1</source>
            <translation>Станок: %1</translation>
        </message>
        <message>
            <source>Load the computer meanwhile as it will be loaded: an hour says more than a minute.</source>
            <translation>Нагружайте компьютер при этом как обычно: час скажет больше минуты.</translation>
        </message>
        <message>
            <source>Locked by the wiring test</source>
            <translation>Заперто: проверка проводки</translation>
        </message>
        <message>
            <source>Locked on hold: resume or stop</source>
            <translation>Пауза: продолжите или остановите</translation>
        </message>
        <message>
            <source>Locked on hold: stop</source>
            <translation>Пауза: остаётся лишь «Стоп»</translation>
        </message>
        <message>
            <source>Locked until the alarm is reset</source>
            <translation>Заперто до сброса аварии</translation>
        </message>
        <message>
            <source>Locked while a program runs</source>
            <translation>Заперто, пока выполняется программа</translation>
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
            <source>Logical levels, looked at 30 times a second; steps by how many there were in between. A recording holds every edge.</source>
            <translation>Логические уровни, 30 раз в секунду; шаги — по их числу между взглядами. В записи есть каждый фронт.</translation>
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
            <source>Looking at this computer</source>
            <translation>Проверяю компьютер</translation>
        </message>
        <message>
            <source>Looking for the sensors</source>
            <translation>Идёт поиск датчиков</translation>
        </message>
        <message>
            <source>Lost at work</source>
            <translation>Пропало в работе</translation>
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
            <source>M4: the machine's spindle does not turn back</source>
            <translation>M4: шпиндель станка не вращается назад</translation>
        </message>
        <message>
            <source>M98 has no P, the number of the subroutine</source>
            <translation>у M98 нет P, номера подпрограммы</translation>
        </message>
        <message>
            <source>M99 ends what M98 has called, and endsub what call has</source>
            <translation>M99 кончает вызванное через M98, а endsub — через call</translation>
        </message>
        <message>
            <source>M99 in the main program begins it again for ever</source>
            <translation>M99 в главной программе начинает её снова без конца</translation>
        </message>
        <message>
            <source>MDI</source>
            <translation>MDI</translation>
        </message>
        <message>
            <source>MOVING</source>
            <translation>ДВИЖЕНИЕ</translation>
        </message>
        <message>
            <source>Machine</source>
            <translation>Станок</translation>
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
            <source>Measure</source>
            <translation>Измерить</translation>
        </message>
        <message>
            <source>Measure: the machine is at work, and would be disturbed</source>
            <translation>Измерить: станок работает, это помешало бы ему</translation>
        </message>
        <message>
            <source>Measure: under way</source>
            <translation>Измерить: идёт</translation>
        </message>
        <message>
            <source>Measured %1 ticks: 99.9 % at most %2 late, %3 missed</source>
            <translation>Измерено тактов: %1; 99,9 % опаздывали не больше %2, пропущено %3</translation>
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
            <source>Mesh</source>
            <translation>Сетка</translation>
        </message>
        <message>
            <source>Meshes (%1)</source>
            <translation>Сетки (%1)</translation>
        </message>
        <message>
            <source>Messages</source>
            <translation>Сообщения</translation>
        </message>
        <message>
            <source>Mirror along</source>
            <translation>Отразить по</translation>
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
            <source>Mist</source>
            <translation>СОЖ распылением</translation>
        </message>
        <message>
            <source>Model</source>
            <translation>Модель</translation>
        </message>
        <message>
            <source>More than %1 mm on %2 % of the surface</source>
            <translation>Более %1 mm на %2 % поверхности</translation>
        </message>
        <message>
            <source>Motion and slicing go by the core's. %1</source>
            <translation>Движение и нарезка идут по профилю ядра. %1</translation>
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
            <source>NO</source>
            <translation>НЕТ</translation>
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
            <source>Needs restart: the core has %1 until it is started anew</source>
            <translation>Нужен перезапуск: у ядра %1, пока его не запустят заново</translation>
        </message>
        <message>
            <source>New</source>
            <translation>Новое</translation>
        </message>
        <message>
            <source>Next</source>
            <translation>Далее</translation>
        </message>
        <message>
            <source>No alarm</source>
            <translation>Аварии нет</translation>
        </message>
        <message>
            <source>No copy of its job is there: open that very job, publish it, Home all, then go on from layer %1.</source>
            <translation>Копии задания нет: откройте то самое задание, передайте его, «Все нули», затем продолжайте со слоя %1.</translation>
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
            <source>No core took it: it has stopped nothing, and drives and spindle are as they were.</source>
            <translation>Его не приняло ни одно ядро: он ничего не остановил, приводы и шпиндель остались как были.</translation>
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
            <source>No job</source>
            <translation>Нет задания</translation>
        </message>
        <message>
            <source>No job is published.</source>
            <translation>Задание не передано.</translation>
        </message>
        <message>
            <source>No job running</source>
            <translation>Задание не выполняется</translation>
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
            <source>No program is open.</source>
            <translation>Программа не открыта.</translation>
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
            <source>No tip goes deeper than this below the blank's surface</source>
            <translation>Острие не идёт глубже этого под поверхность заготовки</translation>
        </message>
        <message>
            <source>No tip goes deeper than this below the cylinder's surface; 0: no limit.</source>
            <translation>Острие не идёт глубже этого под поверхность цилиндра; 0: без предела.</translation>
        </message>
        <message>
            <source>No zero</source>
            <translation>Снять Δ</translation>
        </message>
        <message>
            <source>Nobody heard the emergency stop</source>
            <translation>Аварийный останов никто не услышал</translation>
        </message>
        <message>
            <source>Nobody heard the emergency stop: it has stopped nothing</source>
            <translation>Аварийный останов никто не услышал: он ничего не остановил</translation>
        </message>
        <message>
            <source>None yet</source>
            <translation>Пока нет</translation>
        </message>
        <message>
            <source>Not homed, job published</source>
            <translation>Нули не найдены, задание есть</translation>
        </message>
        <message>
            <source>Not known yet: the job is planned while the machine rests</source>
            <translation>Пока неизвестно: задание планируется, когда станок стоит</translation>
        </message>
        <message>
            <source>Not known: the job could not be planned; page Messages says why</source>
            <translation>Неизвестно: задание не удалось спланировать; причина на странице «Сообщения»</translation>
        </message>
        <message>
            <source>Not known: the job of a recording is not planned</source>
            <translation>Неизвестно: задание записи не планируется</translation>
        </message>
        <message>
            <source>Not now</source>
            <translation>Не сейчас</translation>
        </message>
        <message>
            <source>Not opened, as the machine's profile was not: %1</source>
            <translation>Не открыто, так как не открыт профиль станка: %1</translation>
        </message>
        <message>
            <source>Not opened: %1</source>
            <translation>Не открыто: %1</translation>
        </message>
        <message>
            <source>Not published</source>
            <translation>Не передано</translation>
        </message>
        <message>
            <source>Not published when a window ended: %1 (page Model)</source>
            <translation>Не передано, когда окно закрылось: %1 (страница «Модель»)</translation>
        </message>
        <message>
            <source>Not saved: %1</source>
            <translation>Не сохранено: %1</translation>
        </message>
        <message>
            <source>Not saved: %1 is open here, and would be lost; choose another name</source>
            <translation>Не сохранено: %1 открыт здесь и был бы потерян; выберите другое имя</translation>
        </message>
        <message>
            <source>Not sliced</source>
            <translation>Не нарезано</translation>
        </message>
        <message>
            <source>Not sliced yet.</source>
            <translation>Ещё не нарезано.</translation>
        </message>
        <message>
            <source>Nothing before this line moves anything.</source>
            <translation>До этой строки ничего не движется.</translation>
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
            <source>Nothing is left of it but to stop</source>
            <translation>Её можно только остановить</translation>
        </message>
        <message>
            <source>Nothing is left over</source>
            <translation>Ничего не остаётся</translation>
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
            <source>Nothing moves in this plane.</source>
            <translation>В этой плоскости ничего не движется.</translation>
        </message>
        <message>
            <source>Nothing was changed</source>
            <translation>Ничего не изменено</translation>
        </message>
        <message>
            <source>Nowhere too deep</source>
            <translation>Нигде не слишком глубоко</translation>
        </message>
        <message>
            <source>O has neither a number nor a &lt;name&gt;</source>
            <translation>у O нет ни числа, ни &lt;имени&gt;</translation>
        </message>
        <message>
            <source>O%1 has gone by in the stream</source>
            <translation>O%1 уже прошло в потоке</translation>
        </message>
        <message>
            <source>OFF in other than 3 dimensions</source>
            <translation>OFF не в трёх измерениях</translation>
        </message>
        <message>
            <source>OFF that is binary; save it as text</source>
            <translation>двоичный OFF; сохраните его как текст</translation>
        </message>
        <message>
            <source>Of &lt;style&gt; only rules for element names, .class and #id are followed, not %1.</source>
            <translation>Из &lt;style&gt; учитываются только правила для имён элементов, .class и #id, но не %1.</translation>
        </message>
        <message>
            <source>Of the body that becomes of it</source>
            <translation>Высота получаемого тела</translation>
        </message>
        <message>
            <source>Of the faster head's tool over the surface, in the last second</source>
            <translation>Скорость инструмента более быстрой головки по поверхности за последнюю секунду</translation>
        </message>
        <message>
            <source>Of the picture's 16 bits 8 are taken, as its samples lie in planes.</source>
            <translation>Из 16 бит изображения взято 8: его отсчёты записаны отдельными плоскостями.</translation>
        </message>
        <message>
            <source>Of the rapid ways of a program in G-code</source>
            <translation>Для быстрых перемещений программы в G-коде</translation>
        </message>
        <message>
            <source>Of the tool where it is widest.</source>
            <translation>Диаметр инструмента в самом широком месте.</translation>
        </message>
        <message>
            <source>Of top speed</source>
            <translation>От предела</translation>
        </message>
        <message>
            <source>Of which time messages are shown</source>
            <translation>За какое время показаны сообщения</translation>
        </message>
        <message>
            <source>On a round blank let R1 make a mark: a touch of its tip. Take it out, turn Ψ by exactly 180°, leave Y alone, and let R2 make its own. On a machine without error it falls on R1's.</source>
            <translation>На круглой заготовке сделайте метку R1: касание острия. Отведите его, поверните Ψ ровно на 180°, Y не трогайте, и сделайте метку R2. На станке без погрешности она совпадёт с меткой R1.</translation>
        </message>
        <message>
            <source>On hold the heads stay in the cut, or leave it by retract_mm and come back before it goes on.</source>
            <translation>В паузе головки остаются в резе или отходят на retract_mm и возвращаются, прежде чем продолжить.</translation>
        </message>
        <message>
            <source>On the desk</source>
            <translation>В этом окне</translation>
        </message>
        <message>
            <source>On the virtual clock nothing has to be in time</source>
            <translation>На виртуальных часах опоздать нельзя</translation>
        </message>
        <message>
            <source>On this piece that takes time and cuts nothing. A new blank has to begin with layer 1.</source>
            <translation>На этой детали это займёт время, но ничего не срежет. Новую заготовку надо начинать со слоя 1.</translation>
        </message>
        <message>
            <source>One block of G-code, run by Return</source>
            <translation>Один кадр G-кода, исполняется по Enter</translation>
        </message>
        <message>
            <source>One block; Return runs it</source>
            <translation>Один кадр; Enter исполняет его</translation>
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
            <source>Only an alarm has a place in the flight recorder</source>
            <translation>Место в самописце есть только у аварии</translation>
        </message>
        <message>
            <source>Open</source>
            <translation>Открыть</translation>
        </message>
        <message>
            <source>Open a machine profile</source>
            <translation>Открыть профиль станка</translation>
        </message>
        <message>
            <source>Open a program</source>
            <translation>Открыть программу</translation>
        </message>
        <message>
            <source>Open a program…</source>
            <translation>Открыть программу…</translation>
        </message>
        <message>
            <source>Open in directions</source>
            <translation>Открыта в направлениях</translation>
        </message>
        <message>
            <source>Open its job</source>
            <translation>Открыть задание</translation>
        </message>
        <message>
            <source>Open its job, publish it, Home all, then go on from layer %1.</source>
            <translation>Откройте его задание, передайте его, «Все нули», затем продолжайте со слоя %1.</translation>
        </message>
        <message>
            <source>Open its job, then go on from layer %1.</source>
            <translation>Откройте задание: слой %1.</translation>
        </message>
        <message>
            <source>Open its job: this snapshot has none</source>
            <translation>Открыть задание: в этом снимке его нет</translation>
        </message>
        <message>
            <source>Open model, job, program or recording</source>
            <translation>Открыть модель, задание, программу или запись</translation>
        </message>
        <message>
            <source>Open model, job, program or recording…</source>
            <translation>Открыть модель, задание, программу или запись…</translation>
        </message>
        <message>
            <source>Open points</source>
            <translation>Открытые точки</translation>
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
            <source>Open: the machine's profile is still being read</source>
            <translation>Открыть: профиль станка ещё читается</translation>
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
            <source>Opened without its model: there is nothing to compare the piece with</source>
            <translation>Открыто без модели: деталь не с чем сравнить</translation>
        </message>
        <message>
            <source>Opens the copy of the job that the core has kept; it publishes and moves nothing</source>
            <translation>Открывает копию задания, которую сохранило ядро; ничего не передаёт и не двигает</translation>
        </message>
        <message>
            <source>Opens the model with the form it had</source>
            <translation>Открывает модель с прежними настройками</translation>
        </message>
        <message>
            <source>Opens what the core has recorded, at the moment of this alarm; it moves nothing</source>
            <translation>Открывает запись ядра на моменте этой аварии; ничего не движется</translation>
        </message>
        <message>
            <source>Optional stop</source>
            <translation>Останов по выбору</translation>
        </message>
        <message>
            <source>Optional stop off</source>
            <translation>Останов по выбору выключен</translation>
        </message>
        <message>
            <source>Optional stop on</source>
            <translation>Останов по выбору включён</translation>
        </message>
        <message>
            <source>Output %1</source>
            <translation>Выход %1</translation>
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
            <source>Override of rapids</source>
            <translation>Коррекция быстрых перемещений</translation>
        </message>
        <message>
            <source>Override of rapids %1 %</source>
            <translation>Коррекция быстрых перемещений %1 %</translation>
        </message>
        <message>
            <source>Override of rapids %1 % → %2 %</source>
            <translation>Коррекция быстрых перемещений %1 % → %2 %</translation>
        </message>
        <message>
            <source>P is a number of an output</source>
            <translation>P — номер выхода</translation>
        </message>
        <message>
            <source>P is a system's number</source>
            <translation>P — номер системы координат</translation>
        </message>
        <message>
            <source>P is the number of a subroutine</source>
            <translation>P — номер подпрограммы</translation>
        </message>
        <message>
            <source>P of %1 is 0, off, or 1, on</source>
            <translation>P в %1 — 0 (выкл.) или 1 (вкл.)</translation>
        </message>
        <message>
            <source>P of an arc counts its turns</source>
            <translation>P у дуги — число её оборотов</translation>
        </message>
        <message>
            <source>POSITIONING</source>
            <translation>ПОДВОД</translation>
        </message>
        <message>
            <source>PROGRAM</source>
            <translation>ПРОГРАММА</translation>
        </message>
        <message>
            <source>Page faults, preemptions of the tick</source>
            <translation>Страничные сбои и вытеснения такта</translation>
        </message>
        <message>
            <source>Panels in frames of their own</source>
            <translation>Панели в отдельных окнах</translation>
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
            <source>Pass</source>
            <translation>Проход</translation>
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
            <source>Pictures (%1)</source>
            <translation>Изображения (%1)</translation>
        </message>
        <message>
            <source>Pictures (*.png)</source>
            <translation>Изображения (*.png)</translation>
        </message>
        <message>
            <source>Pin</source>
            <translation>Вывод</translation>
        </message>
        <message>
            <source>Pins recorded: %1</source>
            <translation>Выводы записаны: %1</translation>
        </message>
        <message>
            <source>Placement and slicing</source>
            <translation>Положение и нарезка</translation>
        </message>
        <message>
            <source>Planned time</source>
            <translation>Время по плану</translation>
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
            <source>Point</source>
            <translation>Точка</translation>
        </message>
        <message>
            <source>Point %1</source>
            <translation>Точка %1</translation>
        </message>
        <message>
            <source>Point of that layer to start from</source>
            <translation>Точка этого слоя, с которой начать</translation>
        </message>
        <message>
            <source>Point, Ψ</source>
            <translation>Точка, Ψ</translation>
        </message>
        <message>
            <source>Points / head</source>
            <translation>Точек на головку</translation>
        </message>
        <message>
            <source>Points visited</source>
            <translation>Пройдено точек</translation>
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
            <source>Position not certain any more</source>
            <translation>Положение больше не достоверно</translation>
        </message>
        <message>
            <source>Position of %1</source>
            <translation>Положение %1</translation>
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
            <source>Present positions</source>
            <translation>Текущие положения</translation>
        </message>
        <message>
            <source>Probable unit</source>
            <translation>Вероятная единица</translation>
        </message>
        <message>
            <source>Processor</source>
            <translation>Процессор</translation>
        </message>
        <message>
            <source>Processor of the tick</source>
            <translation>Процессор такта</translation>
        </message>
        <message>
            <source>Profile</source>
            <translation>Профиль</translation>
        </message>
        <message>
            <source>Profile %1 of --profile is not the machine's, which counts by another one</source>
            <translation>Профиль %1 из --profile не от этого станка: он считает по другому</translation>
        </message>
        <message>
            <source>Profile %1 of --profile is not the machine's, which counts by its own, %2</source>
            <translation>Профиль %1 из --profile не от этого станка: он считает по своему, %2</translation>
        </message>
        <message>
            <source>Profile matches job</source>
            <translation>Профиль подходит</translation>
        </message>
        <message>
            <source>Profile not saved</source>
            <translation>Профиль не сохранён</translation>
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
            <source>Program</source>
            <translation>G-код</translation>
        </message>
        <message>
            <source>Program begun</source>
            <translation>Программа начата</translation>
        </message>
        <message>
            <source>Program broke off behind line %1</source>
            <translation>Программа оборвалась после строки %1</translation>
        </message>
        <message>
            <source>Program done, up to line %1</source>
            <translation>Программа выполнена, до строки %1</translation>
        </message>
        <message>
            <source>Program ended</source>
            <translation>Программа закончилась</translation>
        </message>
        <message>
            <source>Program ended by an alarm in line %1</source>
            <translation>Программа прервана аварией в строке %1</translation>
        </message>
        <message>
            <source>Program ended in line %1</source>
            <translation>Программа закончилась в строке %1</translation>
        </message>
        <message>
            <source>Program goes on in line %1</source>
            <translation>Программа продолжена в строке %1</translation>
        </message>
        <message>
            <source>Program held in line %1</source>
            <translation>Пауза программы в строке %1</translation>
        </message>
        <message>
            <source>Program run</source>
            <translation>Программа выполнена</translation>
        </message>
        <message>
            <source>Program slows down to a stop in line %1</source>
            <translation>Программа замедляется до останова в строке %1</translation>
        </message>
        <message>
            <source>Program started: %1</source>
            <translation>Программа пущена: %1</translation>
        </message>
        <message>
            <source>Program stopped in line %1</source>
            <translation>Программа остановлена в строке %1</translation>
        </message>
        <message>
            <source>Program, before its first line</source>
            <translation>Программа, перед первой строкой</translation>
        </message>
        <message>
            <source>Program, line %1</source>
            <translation>Программа, строка %1</translation>
        </message>
        <message>
            <source>Programs in G-code (%1)</source>
            <translation>Программы в G-коде (%1)</translation>
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
            <source>Pulses of %1, with the ways in and out</source>
            <translation>Импульсы %1 вместе с подходом и отходом</translation>
        </message>
        <message>
            <source>Pulses per second R1, R2, Ψ, Y</source>
            <translation>Импульсов в секунду R1, R2, Ψ, Y</translation>
        </message>
        <message>
            <source>Pulses since start</source>
            <translation>Импульсы с пуска</translation>
        </message>
        <message>
            <source>Pulses to go</source>
            <translation>Осталось импульсов</translation>
        </message>
        <message>
            <source>Pump</source>
            <translation>Накачка</translation>
        </message>
        <message>
            <source>Puts this job on the desk</source>
            <translation>Берёт это задание в окно</translation>
        </message>
        <message>
            <source>Puts this job on the desk in place of %1</source>
            <translation>Берёт это задание в окно вместо %1</translation>
        </message>
        <message>
            <source>Q of G64 is not used: the tolerance of P holds for all</source>
            <translation>Q в G64 не используется: допуск P действует для всего</translation>
        </message>
        <message>
            <source>R is below the depth of the hole</source>
            <translation>R ниже дна отверстия</translation>
        </message>
        <message>
            <source>R1 %1 mm</source>
            <translation>R1 %1 mm</translation>
        </message>
        <message>
            <source>R1 %1 · R2 %2 · Y %3 mm · Ψ %4°</source>
            <translation>R1 %1 · R2 %2 · Y %3 мм · Ψ %4°</translation>
        </message>
        <message>
            <source>R1 / mm, Y upwards / mm</source>
            <translation>R1 / mm, вверх Y / mm</translation>
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
            <source>R1 half</source>
            <translation>Половина R1</translation>
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
            <source>R1 plane</source>
            <translation>Плоскость R1</translation>
        </message>
        <message>
            <source>R1 step</source>
            <translation>R1 шаг</translation>
        </message>
        <message>
            <source>R2 %1 mm</source>
            <translation>R2 %1 mm</translation>
        </message>
        <message>
            <source>R2 / mm, Y upwards / mm</source>
            <translation>R2 / mm, вверх Y / mm</translation>
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
            <source>R2 follows R1 (profile: gcode.second_head), and they stand at different radii; bring them to one radius</source>
            <translation>R2 следует за R1 (профиль: gcode.second_head), а радиусы у них разные; приведите их к одному радиусу</translation>
        </message>
        <message>
            <source>R2 half</source>
            <translation>Половина R2</translation>
        </message>
        <message>
            <source>R2 has a letter of its own, or goes where the letter of R1 says.</source>
            <translation>У R2 своя буква, или она идёт туда, куда велит буква R1.</translation>
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
            <source>R2 plane</source>
            <translation>Плоскость R2</translation>
        </message>
        <message>
            <source>R2 stands %1 mm lower than R1 and is under the model in %2 of its layers: there it cuts what holds the model down to a radius of %3 mm.</source>
            <translation>R2 стоит на %1 мм ниже R1 и в своих слоях (их %2) проходит под моделью: там она срезает то, на чём модель держится, до радиуса %3 мм.</translation>
        </message>
        <message>
            <source>R2 step</source>
            <translation>R2 шаг</translation>
        </message>
        <message>
            <source>R2's height error draws the rows up to %1 mm apart, but the tool is only %2 mm wide: between them material stays, as high as the blank; zigzag joining avoids it.</source>
            <translation>Из-за ошибки высоты R2 ряды отстоят до %1 мм, а инструмент шириной всего %2 мм: между ними остаётся материал высотой с заготовку; связь слоёв зигзагом этого избегает.</translation>
        </message>
        <message>
            <source>R2's height error makes the rows uneven: up to %1 mm apart instead of %2 mm; zigzag joining avoids it.</source>
            <translation>Из-за ошибки высоты R2 ряды неравномерны: отстоят до %1 мм вместо %2 мм; связь слоёв зигзагом этого избегает.</translation>
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
            <source>Radii</source>
            <translation>Радиусы</translation>
        </message>
        <message>
            <source>Radius</source>
            <translation>Радиус</translation>
        </message>
        <message>
            <source>Radius along layer %1, mm over Ψ</source>
            <translation>Радиус вдоль слоя %1, mm по Ψ</translation>
        </message>
        <message>
            <source>Radius along the layer, both heads</source>
            <translation>Радиус вдоль слоя, обе головки</translation>
        </message>
        <message>
            <source>Radius of the cylinder that is carved, which the heads keep out of; 0: the job's largest.</source>
            <translation>Радиус обрабатываемого цилиндра, вне которого движутся головки; 0: наибольший радиус задания.</translation>
        </message>
        <message>
            <source>Rapids</source>
            <translation>Быстрые</translation>
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
            <source>Reading the program: %1 %</source>
            <translation>Чтение программы: %1 %</translation>
        </message>
        <message>
            <source>Reading the recording</source>
            <translation>Чтение записи</translation>
        </message>
        <message>
            <source>Reads and judges the file once more, by the machine as it is now</source>
            <translation>Читает и проверяет файл ещё раз, по нынешнему состоянию станка</translation>
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
            <source>Record pins</source>
            <translation>Запись выводов</translation>
        </message>
        <message>
            <source>Record pins: begin it while the machine is at rest</source>
            <translation>Запись выводов: начинайте, когда станок стоит</translation>
        </message>
        <message>
            <source>Record pins: publish a job first</source>
            <translation>Запись выводов: сначала опубликуйте задание</translation>
        </message>
        <message>
            <source>Record pins: the last recording is being written</source>
            <translation>Запись выводов: прошлая запись ещё пишется</translation>
        </message>
        <message>
            <source>Record pins…</source>
            <translation>Записать выводы…</translation>
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
            <source>Recording the pins: %1</source>
            <translation>Идёт запись выводов: %1</translation>
        </message>
        <message>
            <source>Recordings (%1)</source>
            <translation>Записи (%1)</translation>
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
            <source>Reload</source>
            <translation>Перечитать</translation>
        </message>
        <message>
            <source>Removed %1 cm³</source>
            <translation>Снято %1 см³</translation>
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
            <source>Report on the model</source>
            <translation>Отчёт о модели</translation>
        </message>
        <message>
            <source>Report: no job was started</source>
            <translation>Отчёт: ни одно задание не запускалось</translation>
        </message>
        <message>
            <source>Report: open a model first</source>
            <translation>Отчёт: сначала откройте модель</translation>
        </message>
        <message>
            <source>Report: the job is not known</source>
            <translation>Отчёт: задание неизвестно</translation>
        </message>
        <message>
            <source>Report…</source>
            <translation>Отчёт…</translation>
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
            <source>Reset layout</source>
            <translation>Сбросить расположение</translation>
        </message>
        <message>
            <source>Reset the alarm, then home.</source>
            <translation>Сбросьте аварию, затем найдите нули.</translation>
        </message>
        <message>
            <source>Restore backup</source>
            <translation>Вернуть копию</translation>
        </message>
        <message>
            <source>Restore backup: the built-in profile has no file</source>
            <translation>Вернуть копию: у встроенного профиля нет файла</translation>
        </message>
        <message>
            <source>Restore backup: this file has none yet</source>
            <translation>Вернуть копию: у этого файла её ещё нет</translation>
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
            <source>Resume: nothing is left of the program; stop</source>
            <translation>Продолжить: от программы ничего не осталось; остановите</translation>
        </message>
        <message>
            <source>Resume: the program goes on by itself when more of it comes</source>
            <translation>Продолжить: программа продолжится сама, когда поступит её продолжение</translation>
        </message>
        <message>
            <source>Roughing</source>
            <translation>Черновая</translation>
        </message>
        <message>
            <source>Roughing cannot keep its stepover of %1 mm: the job's layers lie %2 mm apart.</source>
            <translation>Черновая обработка не может выдержать шаг %1 мм: слои задания отстоят на %2 мм.</translation>
        </message>
        <message>
            <source>Run a program in G-code…</source>
            <translation>Исполнить программу в G-коде…</translation>
        </message>
        <message>
            <source>Run before: to layer %1 (From layer %2).</source>
            <translation>Прошлая: до слоя %1 («Со слоя» %2).</translation>
        </message>
        <message>
            <source>Run from line %1: first the machine does this</source>
            <translation>Пуск со строки %1: сначала станок делает вот что</translation>
        </message>
        <message>
            <source>Runs it as a process of its own: closing this window ends nothing</source>
            <translation>Исполняет её отдельным процессом: закрытие окна ничего не завершает</translation>
        </message>
        <message>
            <source>Runs the core's own tick loop with nothing in the tick; touches no machine</source>
            <translation>Крутит цикл тактов самого ядра с пустым тактом; станка не касается</translation>
        </message>
        <message>
            <source>S: the machine's spindle is only switched</source>
            <translation>S: шпиндель станка только включается и выключается</translation>
        </message>
        <message>
            <source>SCHED_FIFO, priority %1</source>
            <translation>SCHED_FIFO, приоритет %1</translation>
        </message>
        <message>
            <source>SIMULATOR</source>
            <translation>СИМУЛЯТОР</translation>
        </message>
        <message>
            <source>SQRT of a value below 0</source>
            <translation>SQRT значения меньше 0</translation>
        </message>
        <message>
            <source>STOPPING</source>
            <translation>ОСТАНОВКА</translation>
        </message>
        <message>
            <source>Save</source>
            <translation>Сохранить</translation>
        </message>
        <message>
            <source>Save CSV: nothing was measured yet</source>
            <translation>Сохранить CSV: ещё ничего не измерено</translation>
        </message>
        <message>
            <source>Save CSV…</source>
            <translation>Сохранить CSV…</translation>
        </message>
        <message>
            <source>Save a snapshot</source>
            <translation>Сохранить снимок</translation>
        </message>
        <message>
            <source>Save a snapshot…</source>
            <translation>Сохранить снимок…</translation>
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
            <source>Save its tables…</source>
            <translation>Сохранить таблицы…</translation>
        </message>
        <message>
            <source>Save log…</source>
            <translation>Сохранить журнал…</translation>
        </message>
        <message>
            <source>Save picture…</source>
            <translation>Сохранить изображение…</translation>
        </message>
        <message>
            <source>Save the job</source>
            <translation>Сохранить задание</translation>
        </message>
        <message>
            <source>Save the job…</source>
            <translation>Сохранить задание…</translation>
        </message>
        <message>
            <source>Save the log</source>
            <translation>Сохранить журнал</translation>
        </message>
        <message>
            <source>Save the measurement</source>
            <translation>Сохранить измерение</translation>
        </message>
        <message>
            <source>Save the picture</source>
            <translation>Сохранить изображение</translation>
        </message>
        <message>
            <source>Save the profile</source>
            <translation>Сохранение профиля</translation>
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
            <source>Save the tables</source>
            <translation>Сохранить таблицы</translation>
        </message>
        <message>
            <source>Save: %1 values are wrong</source>
            <translation>Сохранить: неверных значений: %1</translation>
        </message>
        <message>
            <source>Save: nothing was changed</source>
            <translation>Сохранить: ничего не изменено</translation>
        </message>
        <message>
            <source>Save: one value is wrong</source>
            <translation>Сохранить: одно значение неверно</translation>
        </message>
        <message>
            <source>Save: the built-in profile has no file; save it as one</source>
            <translation>Сохранить: у встроенного профиля нет файла; сохраните его под именем</translation>
        </message>
        <message>
            <source>Save: the machine moves</source>
            <translation>Сохранить: станок движется</translation>
        </message>
        <message>
            <source>Saved as %1; open it once the machine is at rest</source>
            <translation>Сохранено как %1; откройте, когда станок остановится</translation>
        </message>
        <message>
            <source>Saved: %1</source>
            <translation>Сохранено: %1</translation>
        </message>
        <message>
            <source>Saving…</source>
            <translation>Сохраняется…</translation>
        </message>
        <message>
            <source>Scale</source>
            <translation>Масштаб</translation>
        </message>
        <message>
            <source>Scale %1</source>
            <translation>Масштаб %1</translation>
        </message>
        <message>
            <source>Scale sets it</source>
            <translation>Задано масштабом</translation>
        </message>
        <message>
            <source>Scales the drawing to go all round</source>
            <translation>Масштабирует чертёж на полный оборот</translation>
        </message>
        <message>
            <source>Scales the model, uniformly</source>
            <translation>Масштабирует модель равномерно</translation>
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
            <source>Seam</source>
            <translation>Стык</translation>
        </message>
        <message>
            <source>Search</source>
            <translation>Поиск</translation>
        </message>
        <message>
            <source>Search the messages</source>
            <translation>Поиск в сообщениях</translation>
        </message>
        <message>
            <source>Second snapshot or job</source>
            <translation>Второй снимок или задание</translation>
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
            <source>See how far the piece is carved before it goes on.</source>
            <translation>Прежде чем продолжить, посмотрите, докуда вырезана деталь.</translation>
        </message>
        <message>
            <source>See to the port's card, cable and driver</source>
            <translation>Проверьте плату порта, кабель и драйвер</translation>
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
            <source>Settings are not kept</source>
            <translation>Настройки не сохраняются</translation>
        </message>
        <message>
            <source>Shape vee: between the flanks.</source>
            <translation>Форма vee: угол между боковыми сторонами.</translation>
        </message>
        <message>
            <source>Show</source>
            <translation>Показать</translation>
        </message>
        <message>
            <source>Show in the flight recorder</source>
            <translation>Показать в самописце</translation>
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
            <source>Shows only what differs from the file, and would be saved</source>
            <translation>Показывает только то, что отличается от файла и было бы сохранено</translation>
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
            <source>Silent at work</source>
            <translation>Молчит в работе</translation>
        </message>
        <message>
            <source>Since %1, tool %2.</source>
            <translation>С %1, инструмент %2.</translation>
        </message>
        <message>
            <source>Since %1.</source>
            <translation>С %1.</translation>
        </message>
        <message>
            <source>Since the start</source>
            <translation>С открытия</translation>
        </message>
        <message>
            <source>Since then the core has ended: there is none to take orders.</source>
            <translation>После этого ядро завершилось: принимать команды некому.</translation>
        </message>
        <message>
            <source>Since then the core is silent: it takes no orders.</source>
            <translation>После этого ядро молчит: команд оно не принимает.</translation>
        </message>
        <message>
            <source>Since when, and with which tool, is not known: no disk tells of it.</source>
            <translation>С каких пор и каким инструментом, неизвестно: ни один диск о ней не сообщает.</translation>
        </message>
        <message>
            <source>Since when, and with which tool, is not known: the disk tells of another piece or layer by now.</source>
            <translation>С какого времени и каким инструментом — неизвестно: диск говорит уже о другой детали или другом слое.</translation>
        </message>
        <message>
            <source>Single block</source>
            <translation>Покадрово</translation>
        </message>
        <message>
            <source>Single block off</source>
            <translation>Покадрово выключено</translation>
        </message>
        <message>
            <source>Single block on</source>
            <translation>Покадрово включено</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Размер</translation>
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
            <source>Slicing …</source>
            <translation>Нарезается …</translation>
        </message>
        <message>
            <source>Slows down along the path and stands on it (Pause, Esc)</source>
            <translation>Замедляется по траектории и останавливается на ней (Pause, Esc)</translation>
        </message>
        <message>
            <source>Smoothed over so far, mm</source>
            <translation>Сглаживание на таком расстоянии, mm</translation>
        </message>
        <message>
            <source>Snapshots (*.snap)</source>
            <translation>Снимки (*.snap)</translation>
        </message>
        <message>
            <source>Snapshots and jobs (*.snap *.job *.psi);;All files (*)</source>
            <translation>Снимки и задания (*.snap *.job *.psi);;Все файлы (*)</translation>
        </message>
        <message>
            <source>Some facets are flipped against their neighbours; carved as if they were not.</source>
            <translation>Некоторые грани вывернуты относительно соседних; режется так, будто это не так.</translation>
        </message>
        <message>
            <source>Sound at an alarm</source>
            <translation>Звук при аварии</translation>
        </message>
        <message>
            <source>Source size</source>
            <translation>Размер модели</translation>
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
            <source>Spindle off, heads outside the blank; table and Y go as they would</source>
            <translation>Шпиндель выключен, головки вне заготовки; стол и Y идут как обычно</translation>
        </message>
        <message>
            <source>Spindle off. Put a pin of known diameter on the axis, home, and bring %1 to it with the Jog panel, the last steps by hundredths, until the tip just touches: a slip of paper is held.</source>
            <translation>Шпиндель выключен. Поставьте на ось штифт известного диаметра, найдите ноль и подведите к нему %1 панелью ручного перемещения, последние шаги по сотым, пока острие не коснётся: полоска бумаги зажата.</translation>
        </message>
        <message>
            <source>Spindle on</source>
            <translation>Шпиндель включён</translation>
        </message>
        <message>
            <source>Spindle on or off</source>
            <translation>Шпиндель вкл./выкл.</translation>
        </message>
        <message>
            <source>Start</source>
            <translation>Пуск</translation>
        </message>
        <message>
            <source>Start anew</source>
            <translation>Начать заново</translation>
        </message>
        <message>
            <source>Start anew…</source>
            <translation>Начать заново…</translation>
        </message>
        <message>
            <source>Start dry run</source>
            <translation>Пуск вхолостую</translation>
        </message>
        <message>
            <source>Start dry run from layer %1</source>
            <translation>Пуск вхолостую со слоя %1</translation>
        </message>
        <message>
            <source>Start dry run from layer %1, point %2</source>
            <translation>Пуск вхолостую со слоя %1, точка %2</translation>
        </message>
        <message>
            <source>Start dry run from layer 1</source>
            <translation>Пуск вхолостую со слоя 1</translation>
        </message>
        <message>
            <source>Start from layer %1</source>
            <translation>Пуск со слоя %1</translation>
        </message>
        <message>
            <source>Start from layer %1, point %2</source>
            <translation>Пуск со слоя %1, точка %2</translation>
        </message>
        <message>
            <source>Start from layer %1, point %2: what comes before it is left as it is. The heads go in at that very point, at plunge speed.</source>
            <translation>Пуск со слоя %1, точка %2: что до неё, остаётся как есть. Головки подводятся именно в этой точке, со скоростью врезания.</translation>
        </message>
        <message>
            <source>Start from layer %1: the layers below are left as they are. The heads go out, Y goes to the layer, then the heads go in at plunge speed.</source>
            <translation>Пуск со слоя %1: слои ниже остаются как есть. Головки отходят, Y идёт к слою, затем головки подводятся со скоростью врезания.</translation>
        </message>
        <message>
            <source>Start from layer 1</source>
            <translation>Пуск со слоя 1</translation>
        </message>
        <message>
            <source>Start it again; home before carving on</source>
            <translation>Запустите его снова; перед продолжением найдите нули</translation>
        </message>
        <message>
            <source>Start program</source>
            <translation>Пуск программы</translation>
        </message>
        <message>
            <source>Start psicarve-rtcore</source>
            <translation>Запустите psicarve-rtcore</translation>
        </message>
        <message>
            <source>Start psicarve-rtcore with that profile, or the window without it</source>
            <translation>Запустите psicarve-rtcore с этим профилем или окно без него</translation>
        </message>
        <message>
            <source>Start spindle</source>
            <translation>Вкл. шпиндель</translation>
        </message>
        <message>
            <source>Start, One layer and From layer carve nothing: table and Y go as they would, heads outside the blank, spindle off</source>
            <translation>Пуск, Один слой и Со слоя ничего не режут: стол и Y движутся как при резьбе, головки вне заготовки, шпиндель выключен</translation>
        </message>
        <message>
            <source>Start: a dry run switches nothing; switch the spindle off first</source>
            <translation>Пуск: холостой прогон ничего не переключает; сначала выключите шпиндель</translation>
        </message>
        <message>
            <source>Start: a job is being made</source>
            <translation>Пуск: задание составляется</translation>
        </message>
        <message>
            <source>Start: a program runs</source>
            <translation>Пуск: выполняется программа</translation>
        </message>
        <message>
            <source>Start: a recording is shown; leave replay first</source>
            <translation>Пуск: показана запись; сначала выйдите из просмотра</translation>
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
            <source>Start: another program runs; stop it first</source>
            <translation>Пуск: идёт другая программа; сначала остановите её</translation>
        </message>
        <message>
            <source>Start: axis %1 is not homed</source>
            <translation>Пуск: ноль оси %1 не найден</translation>
        </message>
        <message>
            <source>Start: errors in the program: %1</source>
            <translation>Пуск: ошибок в программе: %1</translation>
        </message>
        <message>
            <source>Start: it was judged for another profile; decode it again</source>
            <translation>Пуск: проверена по другому профилю; разберите её снова</translation>
        </message>
        <message>
            <source>Start: it was read with another block delete; decode it again</source>
            <translation>Пуск: прочитана с другим пропуском кадров; разберите её снова</translation>
        </message>
        <message>
            <source>Start: no job is published</source>
            <translation>Пуск: задание не передано</translation>
        </message>
        <message>
            <source>Start: no layer was finished</source>
            <translation>Пуск: ни один слой не закончен</translation>
        </message>
        <message>
            <source>Start: no program is open</source>
            <translation>Пуск: программа не открыта</translation>
        </message>
        <message>
            <source>Start: on hold; only Stop is left</source>
            <translation>Пуск: пауза; остаётся лишь «Стоп»</translation>
        </message>
        <message>
            <source>Start: on hold; resume or stop</source>
            <translation>Пуск: пауза; продолжите или остановите</translation>
        </message>
        <message>
            <source>Start: pre-flight, %1: %2</source>
            <translation>Пуск: проверка перед пуском, %1: %2</translation>
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
            <source>Start: the core's profile is not known; open it on page Profile</source>
            <translation>Пуск: профиль ядра неизвестен; откройте его на странице «Профиль»</translation>
        </message>
        <message>
            <source>Start: the drives are off; home all axes</source>
            <translation>Пуск: приводы отключены; найдите нуль всех осей</translation>
        </message>
        <message>
            <source>Start: the file has been changed since it was read; decode it again</source>
            <translation>Пуск: файл изменён после чтения; разберите его снова</translation>
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
            <source>Start: the heads wait at the first point of a job; stop first</source>
            <translation>Пуск: головки ждут у первой точки задания; сначала остановите</translation>
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
            <source>Start: the program ends in line %1</source>
            <translation>Пуск: программа кончается в строке %1</translation>
        </message>
        <message>
            <source>Start: the program is being read</source>
            <translation>Пуск: программа читается</translation>
        </message>
        <message>
            <source>Start: the program is on its way</source>
            <translation>Пуск: программа уже в пути</translation>
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
            <source>Stepdown</source>
            <translation>Шаг вглубь</translation>
        </message>
        <message>
            <source>Stepover</source>
            <translation>Шаг слоёв</translation>
        </message>
        <message>
            <source>Still open: %1</source>
            <translation>По-прежнему открыто: %1</translation>
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
            <source>Stop recording</source>
            <translation>Остановить запись</translation>
        </message>
        <message>
            <source>Stop spindle</source>
            <translation>Выкл. шпиндель</translation>
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
            <source>Stroke widths</source>
            <translation>Ширина линий</translation>
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
            <source>Surface</source>
            <translation>Поверхность</translation>
        </message>
        <message>
            <source>Surface closed, all facets turned alike</source>
            <translation>Поверхность замкнута, все грани повёрнуты одинаково</translation>
        </message>
        <message>
            <source>Surface that no tip reached</source>
            <translation>Поверхность, не тронутая резцом</translation>
        </message>
        <message>
            <source>Switch %1 is still closed</source>
            <translation>Выключатель %1 всё ещё замкнут</translation>
        </message>
        <message>
            <source>Switch the machine off by its own switch</source>
            <translation>Выключите станок его собственным выключателем</translation>
        </message>
        <message>
            <source>Switched off: %1</source>
            <translation>Выключено: %1</translation>
        </message>
        <message>
            <source>Switched on: %1</source>
            <translation>Включено: %1</translation>
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
            <source>Table and Y go as they would, heads outside the blank, spindle off (Ctrl+Enter)</source>
            <translation>Стол и Y движутся как при резьбе, головки вне заготовки, шпиндель выключен (Ctrl+Enter)</translation>
        </message>
        <message>
            <source>Tables (%1)</source>
            <translation>Таблицы (%1)</translation>
        </message>
        <message>
            <source>Tables (*.csv *.json)</source>
            <translation>Таблицы (*.csv *.json)</translation>
        </message>
        <message>
            <source>Tables (*.csv)</source>
            <translation>Таблицы (*.csv)</translation>
        </message>
        <message>
            <source>Take over</source>
            <translation>Взять</translation>
        </message>
        <message>
            <source>Take over: a job is being made</source>
            <translation>Взять: задание составляется</translation>
        </message>
        <message>
            <source>Take up again</source>
            <translation>Вернуть на стол</translation>
        </message>
        <message>
            <source>Take up again: %1, %2 layers × %3 points</source>
            <translation>Вернуть на стол: %1, слоёв %2 × точек %3</translation>
        </message>
        <message>
            <source>Take up again: %1, %2 layers × %3 points, sliced</source>
            <translation>Вернуть на стол: %1, слоёв %2 × точек %3, нарезано</translation>
        </message>
        <message>
            <source>Taken over from the core: profile %1</source>
            <translation>Взят из ядра профиль %1</translation>
        </message>
        <message>
            <source>Taken over from the machine: %1</source>
            <translation>Взято из станка: %1</translation>
        </message>
        <message>
            <source>Takes the position that the core counts now</source>
            <translation>Берёт положение, которое сейчас считает ядро</translation>
        </message>
        <message>
            <source>Takes this away once it was read; it moves and stops nothing</source>
            <translation>Убирает сообщение, когда оно прочитано; ничего не двигает и не останавливает</translation>
        </message>
        <message>
            <source>Takes this away until more is carved; it moves and forgets nothing</source>
            <translation>Убирает это, пока не вырезано больше; ничего не движет и не забывает</translation>
        </message>
        <message>
            <source>Text (*.log *.txt)</source>
            <translation>Текст (*.log *.txt)</translation>
        </message>
        <message>
            <source>Text is left out: convert it to paths in the drawing program.</source>
            <translation>Текст пропущен: преобразуйте его в контуры в графической программе.</translation>
        </message>
        <message>
            <source>The axis of the file that changes its sign, before the model is turned</source>
            <translation>Ось файла, меняющая знак до поворота модели</translation>
        </message>
        <message>
            <source>The axis that is at its top speed or acceleration, else the feed</source>
            <translation>Ось, достигшая предельной скорости или ускорения, иначе подача</translation>
        </message>
        <message>
            <source>The backup is being read</source>
            <translation>Копия читается</translation>
        </message>
        <message>
            <source>The blank as carved so far</source>
            <translation>Заготовка, как она вырезана сейчас</translation>
        </message>
        <message>
            <source>The blank reaches out to %1 mm, which is more than the heads can clear, %2 mm.</source>
            <translation>Заготовка доходит до %1 mm, это больше, чем могут обойти головки, %2 mm.</translation>
        </message>
        <message>
            <source>The blank's radius of %1 mm is less than the model's, %2 mm.</source>
            <translation>Радиус заготовки %1 mm меньше радиуса модели, %2 mm.</translation>
        </message>
        <message>
            <source>The blank's radius of %1 mm is more than the heads can clear, %2 mm.</source>
            <translation>Радиус заготовки %1 mm больше, чем могут обойти головки, %2 mm.</translation>
        </message>
        <message>
            <source>The blank's top stands %1 mm above the table, the model's %2 mm.</source>
            <translation>Верх заготовки на %1 mm над столом, верх модели — на %2 mm.</translation>
        </message>
        <message>
            <source>The blank, the passes' depths and the tool, to scale</source>
            <translation>Заготовка, глубины проходов и инструмент в масштабе</translation>
        </message>
        <message>
            <source>The block has %1 bytes; a line has %2 at most.</source>
            <translation>В кадре %1 байт; в строке не больше %2.</translation>
        </message>
        <message>
            <source>The block is run.</source>
            <translation>Кадр выполнен.</translation>
        </message>
        <message>
            <source>The block runs.</source>
            <translation>Кадр исполняется.</translation>
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
            <source>The computer's memory says %1 layers, its disk %2: the lower number is taken.</source>
            <translation>В памяти компьютера слоёв: %1, на диске: %2; берётся меньшее число.</translation>
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
            <source>The core has ended in layer %1, point %2</source>
            <translation>Ядро завершилось в слое %1, точке %2</translation>
        </message>
        <message>
            <source>The core has ended in line %1 of its program</source>
            <translation>Ядро завершилось в строке %1 программы</translation>
        </message>
        <message>
            <source>The core has ended in the middle of its work</source>
            <translation>Ядро завершилось посреди работы</translation>
        </message>
        <message>
            <source>The core has started: version %1, port %2, process %3</source>
            <translation>Ядро запущено: версия %1, порт %2, процесс %3</translation>
        </message>
        <message>
            <source>The core has this job.</source>
            <translation>Это задание есть у ядра.</translation>
        </message>
        <message>
            <source>The core heard no command for a second, no stop either: free the computer of other work, look after its memory and disks; reset the alarm, then start again.</source>
            <translation>Секунду ядро не слышало ни одной команды, даже стопа: освободите компьютер от другой работы, проверьте его память и диски; сбросьте аварию, затем запустите снова.</translation>
        </message>
        <message>
            <source>The core is heard again</source>
            <translation>Ядро снова отвечает</translation>
        </message>
        <message>
            <source>The core is silent</source>
            <translation>Ядро молчит</translation>
        </message>
        <message>
            <source>The core is silent in the middle of its work</source>
            <translation>Ядро замолчало посреди работы</translation>
        </message>
        <message>
            <source>The core is silent, in layer %1, point %2</source>
            <translation>Ядро замолчало в слое %1, точке %2</translation>
        </message>
        <message>
            <source>The core is silent, in line %1 of its program</source>
            <translation>Ядро молчит, в строке %1 программы</translation>
        </message>
        <message>
            <source>The core runs on a virtual clock: no tick is ever late</source>
            <translation>Ядро идёт по виртуальным часам: такты не запаздывают</translation>
        </message>
        <message>
            <source>The core runs with another profile than %1; its file was not found.</source>
            <translation>Ядро работает с другим профилем, а не с %1; файл того профиля не найден.</translation>
        </message>
        <message>
            <source>The core runs with profile %1, not with %2 of --profile</source>
            <translation>Ядро работает с профилем %1, а не с %2 из --profile</translation>
        </message>
        <message>
            <source>The core's profile is not known: give the window its file, with --profile</source>
            <translation>Профиль ядра неизвестен: задайте окну его файл ключом --profile</translation>
        </message>
        <message>
            <source>The core's tick</source>
            <translation>Такт ядра</translation>
        </message>
        <message>
            <source>The depth limit of %1 mm below the blank's surface keeps the heads out of %2 of the points, by up to %3 mm.</source>
            <translation>Предел глубины %1 mm под поверхностью заготовки не пускает головки в %2 точек, недорез до %3 mm.</translation>
        </message>
        <message>
            <source>The desktop's bell, once at each new alarm; not for recordings, nor for what was there before the window</source>
            <translation>Сигнал рабочего стола, один раз при каждой новой аварии; не для записей и не для того, что было до этого окна</translation>
        </message>
        <message>
            <source>The disk does not take how far the piece has come</source>
            <translation>Диск не принимает запись о том, докуда вырезана деталь</translation>
        </message>
        <message>
            <source>The drawing does not say how large it is: its units are taken as 1/96 inch (0.26 mm).</source>
            <translation>В чертеже не указан размер: единица принята за 1/96 дюйма (0.26 mm).</translation>
        </message>
        <message>
            <source>The drawing does not say its units: they are taken as millimetres.</source>
            <translation>В чертеже не указаны единицы: приняты миллиметры.</translation>
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
            <source>The file has been changed since it was read: decode it again.</source>
            <translation>Файл изменён после чтения: разберите его снова.</translation>
        </message>
        <message>
            <source>The file is not there any more</source>
            <translation>Файла больше нет</translation>
        </message>
        <message>
            <source>The file was written since it was opened</source>
            <translation>Файл изменён после открытия</translation>
        </message>
        <message>
            <source>The file was written since: it comes as it is now, and is not sliced.</source>
            <translation>Файл с тех пор записан заново: он откроется таким, какой есть, и без нарезки.</translation>
        </message>
        <message>
            <source>The finishing pass alone</source>
            <translation>Только чистовой проход</translation>
        </message>
        <message>
            <source>The flight recorder does not reach back to that moment any more</source>
            <translation>Самописец уже не доходит до того момента</translation>
        </message>
        <message>
            <source>The flight recorder is being saved</source>
            <translation>Самописец сохраняется</translation>
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
            <source>The heads can go only %1 mm out of the blank before they begin, not the %2 mm of job.clearance_mm.</source>
            <translation>До начала головки могут отойти от заготовки только на %1 мм, а не на %2 мм, как требует job.clearance_mm.</translation>
        </message>
        <message>
            <source>The heads come in: %1.</source>
            <translation>Головки подходят: %1.</translation>
        </message>
        <message>
            <source>The heads may stand in the piece.</source>
            <translation>Головки могут стоять в заготовке.</translation>
        </message>
        <message>
            <source>The heads stay out (dry run).</source>
            <translation>Головки остаются снаружи (холостой прогон).</translation>
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
            <source>The layer's begin, or the point at which the heads go in</source>
            <translation>Начало слоя или точка, в которой подводятся головки</translation>
        </message>
        <message>
            <source>The layers lie %1 mm apart, but the tool is only %2 mm wide: between them material stays, as high as the blank; more layers leave less.</source>
            <translation>Слои отстоят на %1 мм, а инструмент шириной всего %2 мм: между ними остаётся материал высотой с заготовку; чем больше слоёв, тем его меньше.</translation>
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
            <source>The machine is at work no more: the window can be closed</source>
            <translation>Станок больше не работает: окно можно закрыть</translation>
        </message>
        <message>
            <source>The machine is at work. It does not need this window: what is to become of it?</source>
            <translation>Станок работает. Это окно ему не нужно: что с ним делать?</translation>
        </message>
        <message>
            <source>The machine is under way; at rest, without a job that waits or is held</source>
            <translation>Станок работает; нужен покой без ожидающего или удержанного задания</translation>
        </message>
        <message>
            <source>The machine still has its job of before: Start carves %1.</source>
            <translation>У станка прежнее задание: «Пуск» вырезает %1.</translation>
        </message>
        <message>
            <source>The machine's history is not shown in full</source>
            <translation>История станка показана не полностью</translation>
        </message>
        <message>
            <source>The machine's profile is not known here: pins are those of the built-in profile.</source>
            <translation>Профиль станка здесь неизвестен: выводы взяты из встроенного профиля.</translation>
        </message>
        <message>
            <source>The mesh has holes, which are carved down to what lies behind them, or to the core.</source>
            <translation>В сетке есть дыры: в них режется до того, что лежит за ними, или до сердцевины.</translation>
        </message>
        <message>
            <source>The mesh is inside out; carved as if it were not.</source>
            <translation>Сетка вывернута наизнанку; режется так, будто это не так.</translation>
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
            <source>The model stands out of the blank, which is off the table's axis, by up to %1 mm in direction %2°.</source>
            <translation>Заготовка смещена от оси стола, и модель выступает из неё до %1 mm в направлении %2°.</translation>
        </message>
        <message>
            <source>The model stands so far from its file's origin that its coordinates are rounded to %1 mm, more than a pulse (%2 mm): move it to the origin before it is exported.</source>
            <translation>Модель стоит так далеко от начала координат файла, что её координаты округлены до %1 mm, больше импульса (%2 mm): перенесите её к началу перед экспортом.</translation>
        </message>
        <message>
            <source>The most between two of roughing's layers; 0: as the tool allows.</source>
            <translation>Наибольшее расстояние между слоями черновой обработки; 0: сколько допускает инструмент.</translation>
        </message>
        <message>
            <source>The most between two of roughing's layers; auto: as the tool allows</source>
            <translation>Наибольшее расстояние между слоями черновой обработки; авто: сколько допускает инструмент</translation>
        </message>
        <message>
            <source>The old file is kept as a backup. A core takes a profile when it starts.</source>
            <translation>Старый файл остаётся копией. Ядро берёт профиль при запуске.</translation>
        </message>
        <message>
            <source>The old file is kept as a backup. Then start the core with the new one, and slice models anew: a job is made for one calibration.</source>
            <translation>Старый файл остаётся резервной копией. Затем запустите ядро с новым и нарежьте модели заново: задание делается для одной калибровки.</translation>
        </message>
        <message>
            <source>The one before ended in order</source>
            <translation>Предыдущее завершилось штатно</translation>
        </message>
        <message>
            <source>The one before has no end, and the computer was started again since</source>
            <translation>У предыдущего нет конца, компьютер с тех пор перезапускался</translation>
        </message>
        <message>
            <source>The one before has no end: killed, crashed, or the computer was switched off</source>
            <translation>У предыдущего нет конца: убито, упало или компьютер выключили</translation>
        </message>
        <message>
            <source>The one before was killed or crashed</source>
            <translation>Предыдущее убито или упало</translation>
        </message>
        <message>
            <source>The picture does not say what its fourth sample is: it is taken as transparency (alpha).</source>
            <translation>В изображении не сказано, что такое его четвёртый отсчёт: он взят как прозрачность (альфа).</translation>
        </message>
        <message>
            <source>The picture ends before the full turn in steps to the white rest: of up to %1 mm at its left edge and %2 mm at its right one. White edges, or all round, leave none.</source>
            <translation>Изображение занимает не весь оборот и кончается уступами к белому остатку: до %1 mm у левого края и до %2 mm у правого. С белыми краями или по кругу их не будет.</translation>
        </message>
        <message>
            <source>The picture is in colour; its brightness is taken.</source>
            <translation>Изображение цветное; взята его яркость.</translation>
        </message>
        <message>
            <source>The picture's %1 x %2 pixels are averaged to %3 x %4.</source>
            <translation>Пиксели изображения %1 x %2 усреднены до %3 x %4.</translation>
        </message>
        <message>
            <source>The picture's left and right edges do not meet: a step of up to %1 mm at direction 0. Seam: blended makes it smooth.</source>
            <translation>Левый и правый края изображения не сходятся: уступ до %1 mm у направления 0. Выбор «Стык: плавный» сгладит его.</translation>
        </message>
        <message>
            <source>The port does not answer</source>
            <translation>Порт не отвечает</translation>
        </message>
        <message>
            <source>The profile is being opened</source>
            <translation>Профиль открывается</translation>
        </message>
        <message>
            <source>The profile is being saved</source>
            <translation>Профиль сохраняется</translation>
        </message>
        <message>
            <source>The profile is still being saved. Lose what is not saved yet?</source>
            <translation>Профиль ещё сохраняется. Потерять то, что ещё не сохранено?</translation>
        </message>
        <message>
            <source>The program is on its way to the machine.</source>
            <translation>Программа на пути к станку.</translation>
        </message>
        <message>
            <source>The program runs. %1</source>
            <translation>Программа идёт. %1</translation>
        </message>
        <message>
            <source>The program's path; rapid moves are dashed</source>
            <translation>Путь программы; быстрые перемещения — пунктиром</translation>
        </message>
        <message>
            <source>The program's text</source>
            <translation>Текст программы</translation>
        </message>
        <message>
            <source>The real machine at port %1</source>
            <translation>Настоящий станок на порту %1</translation>
        </message>
        <message>
            <source>The run before came to layer %1 of %2: if its piece is still mounted, From layer %3 goes on with it, and layer 1 carves it again.</source>
            <translation>Прошлая обработка дошла до слоя %1 из %2: если её деталь ещё закреплена, «Со слоя» %3 продолжит её, а со слоя 1 она будет вырезана снова.</translation>
        </message>
        <message>
            <source>The run before came to layer %1: if its piece is still mounted, From layer %2 goes on with it.</source>
            <translation>Прошлая обработка дошла до слоя %1: если её деталь ещё закреплена, «Со слоя» %2 продолжит её.</translation>
        </message>
        <message>
            <source>The shared memory was removed or damaged from outside: reset the alarm and publish the job again.</source>
            <translation>Общая память удалена или повреждена извне: сбросьте аварию и передайте задание снова.</translation>
        </message>
        <message>
            <source>The spindle goes on.</source>
            <translation>Шпиндель включается.</translation>
        </message>
        <message>
            <source>The spindle is off. No axis moved, and drives without an enable line stay on.</source>
            <translation>Шпиндель выключен. Ни одна ось не двигалась, а приводы без линии включения остаются под током.</translation>
        </message>
        <message>
            <source>The spindle is on and stays on.</source>
            <translation>Шпиндель включён и остаётся включённым.</translation>
        </message>
        <message>
            <source>The spindle stays off until the program turns it on.</source>
            <translation>Шпиндель выключен, пока программа его не включит.</translation>
        </message>
        <message>
            <source>The table had lost steps there. Measure the piece, or go on from the first of these layers</source>
            <translation>Стол там потерял шаги. Измерьте деталь или продолжите с первого из этих слоёв</translation>
        </message>
        <message>
            <source>The table has lost steps</source>
            <translation>Стол потерял шаги</translation>
        </message>
        <message>
            <source>The table is taken as it stands: R2's angle and height errors stay in it.</source>
            <translation>Таблица берётся как есть: ошибки угла и высоты R2 остаются в ней.</translation>
        </message>
        <message>
            <source>The table keeps turning, runs to and fro, or the heads rise as it turns, without links; a job carries its own.</source>
            <translation>Стол вращается дальше, ходит туда и обратно, или головки поднимаются по ходу вращения без переходов; у задания это своё.</translation>
        </message>
        <message>
            <source>The text has more than one line; only one block is run.</source>
            <translation>В тексте больше одной строки; выполняется только один кадр.</translation>
        </message>
        <message>
            <source>The tool alone: no blank is chosen</source>
            <translation>Только инструмент: заготовка не выбрана</translation>
        </message>
        <message>
            <source>The tool cuts %1 mm deep, but the job goes %2 mm into the blank.</source>
            <translation>Инструмент режет на глубину %1 mm, а задание идёт на %2 mm в заготовку.</translation>
        </message>
        <message>
            <source>The tool has become this much shorter since the touch-off; added to the tip offset.</source>
            <translation>На столько инструмент укоротился после касания; прибавляется к смещению острия.</translation>
        </message>
        <message>
            <source>The tool is a point, which leaves no width: grooves are as wide as the real tool cuts them.</source>
            <translation>Инструмент — точка без ширины: канавки будут шириной с настоящий инструмент.</translation>
        </message>
        <message>
            <source>The tool leaves</source>
            <translation>Инструмент оставит</translation>
        </message>
        <message>
            <source>The tool leaves (draft)</source>
            <translation>Инструмент оставит (набросок)</translation>
        </message>
        <message>
            <source>The typed block runs. %1</source>
            <translation>Введённый кадр исполняется. %1</translation>
        </message>
        <message>
            <source>The unfinished piece is forgotten.</source>
            <translation>Незаконченная деталь забыта.</translation>
        </message>
        <message>
            <source>The window stays open: the core has not taken the hold</source>
            <translation>Окно остаётся открытым: ядро не приняло паузу</translation>
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
            <source>The Ψ index was expected at %1 pulses and came at %2: the table stands %3 off. Likely it was held or braked.</source>
            <translation>Ноль Ψ ожидался на %1 импульсах, а пришёл на %2: стол стоит с отклонением %3. Вероятно, его удержали или притормозили.</translation>
        </message>
        <message>
            <source>The Ψ index was expected at %1 pulses and came at %2: the table stands %3 off. Likely it was held or braked. Layer %4 can be wrong.</source>
            <translation>Ноль Ψ ожидался на %1 импульсах, а пришёл на %2: стол стоит с отклонением %3. Вероятно, его удержали или притормозили. Слой %4 может быть неверным.</translation>
        </message>
        <message>
            <source>The Ψ index was expected at %1 pulses and came at %2: the table stands %3 off. Likely it was held or braked. Layers %4 to %5 can be wrong.</source>
            <translation>Ноль Ψ ожидался на %1 импульсах, а пришёл на %2: стол стоит с отклонением %3. Вероятно, его удержали или притормозили. Слои с %4 по %5 могут быть неверными.</translation>
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
            <source>Then: heads out, Ψ to %1°, Y to %2 mm, spindle on, heads in to R1 %3, R2 %4 mm.</source>
            <translation>Затем: головки наружу, Ψ на %1°, Y на %2 mm, шпиндель вкл., головки внутрь до R1 %3, R2 %4 mm.</translation>
        </message>
        <message>
            <source>These outputs go on: %1.</source>
            <translation>Включаются выходы: %1.</translation>
        </message>
        <message>
            <source>This computer</source>
            <translation>Этот компьютер</translation>
        </message>
        <message>
            <source>This core keeps pieces elsewhere, or nowhere: it is another core's.</source>
            <translation>Это ядро хранит записи в другом месте или нигде: эта — другого ядра.</translation>
        </message>
        <message>
            <source>This is known from the disk alone. Go on only if this very piece is still mounted, as it was, with this tool.</source>
            <translation>Это известно только с диска. Продолжайте, только если эта самая деталь всё ещё закреплена, как была, и с тем же инструментом.</translation>
        </message>
        <message>
            <source>This user has no folder to keep it in</source>
            <translation>У этого пользователя нет папки для неё</translation>
        </message>
        <message>
            <source>This window goes by it from now on, also without a core; no file is changed</source>
            <translation>Отныне окно работает по нему, в том числе без ядра; файлы не меняются</translation>
        </message>
        <message>
            <source>Thread</source>
            <translation>Поток</translation>
        </message>
        <message>
            <source>Tick</source>
            <translation>Такт</translation>
        </message>
        <message>
            <source>Tick to measure with</source>
            <translation>Такт для измерения</translation>
        </message>
        <message>
            <source>Ticks by how late they were (logarithmic)</source>
            <translation>Такты по запаздыванию (логарифмически)</translation>
        </message>
        <message>
            <source>Ticks in time</source>
            <translation>Такты вовремя</translation>
        </message>
        <message>
            <source>Ticks in which a step waited for its pin</source>
            <translation>Такты с ожиданием вывода</translation>
        </message>
        <message>
            <source>Ticks measured, missed</source>
            <translation>Тактов измерено, пропущено</translation>
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
            <source>Ticks were missed; motors may have lost steps.</source>
            <translation>Такты пропущены; двигатели могли потерять шаги.</translation>
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
            <source>To a position: one axis or several, straight or on an arc</source>
            <translation>В положение: одна или несколько осей, по прямой или по дуге</translation>
        </message>
        <message>
            <source>To be looked at before Start: %1</source>
            <translation>Взглянуть перед пуском: %1</translation>
        </message>
        <message>
            <source>To go: %1</source>
            <translation>Осталось: %1</translation>
        </message>
        <message>
            <source>To run it again</source>
            <translation>Чтобы повторить</translation>
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
            <source>Too deep by %1 mm at most, at %2°, %3 mm high</source>
            <translation>Слишком глубоко не более чем на %1 mm, при %2° на высоте %3 mm</translation>
        </message>
        <message>
            <source>Tool</source>
            <translation>Инструмент</translation>
        </message>
        <message>
            <source>Tool over surface; a job carries its own.</source>
            <translation>Скорость инструмента по поверхности; у задания она своя.</translation>
        </message>
        <message>
            <source>Tools</source>
            <translation>Инструменты</translation>
        </message>
        <message>
            <source>Top</source>
            <translation>Сверху</translation>
        </message>
        <message>
            <source>Top of the cylinder above the table; 0: not known.</source>
            <translation>Верх цилиндра над столом; 0: неизвестен.</translation>
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
            <source>Touch-off of %1</source>
            <translation>Касание %1</translation>
        </message>
        <message>
            <source>Touch-off, two marks and tool wear become values of the profile, step by step</source>
            <translation>Касание, две метки и износ инструмента шаг за шагом становятся значениями профиля</translation>
        </message>
        <message>
            <source>Touch-off: the real tip stands this much further out than counted.</source>
            <translation>Касание: настоящее остриё стоит на столько дальше наружу, чем по счёту.</translation>
        </message>
        <message>
            <source>Touches no machine. Measure does so at length.</source>
            <translation>Станка не касается. «Измерить» проверяет дольше.</translation>
        </message>
        <message>
            <source>Trace to verify</source>
            <translation>Трасса для сверки</translation>
        </message>
        <message>
            <source>Traces (*.trace *.vcd);;All files (*)</source>
            <translation>Трассы (*.trace *.vcd);;Все файлы (*)</translation>
        </message>
        <message>
            <source>Turn about X</source>
            <translation>Повернуть вокруг X</translation>
        </message>
        <message>
            <source>Turn, mirror</source>
            <translation>Поворот</translation>
        </message>
        <message>
            <source>Turns or mirrors the model before it is placed</source>
            <translation>Поворачивает или отражает модель до размещения</translation>
        </message>
        <message>
            <source>Two marks</source>
            <translation>Две метки</translation>
        </message>
        <message>
            <source>Undercut</source>
            <translation>Поднутрение</translation>
        </message>
        <message>
            <source>Undercut: choose Model first</source>
            <translation>Поднутрение: сначала выберите «Модель»</translation>
        </message>
        <message>
            <source>Undercut: it is being looked for</source>
            <translation>Поднутрение: идёт поиск</translation>
        </message>
        <message>
            <source>Undercut: open a model first</source>
            <translation>Поднутрение: сначала откройте модель</translation>
        </message>
        <message>
            <source>Undercut: there is none</source>
            <translation>Поднутрение: его нет</translation>
        </message>
        <message>
            <source>Undo all</source>
            <translation>Вернуть всё</translation>
        </message>
        <message>
            <source>Undo all: nothing was changed</source>
            <translation>Вернуть всё: ничего не изменено</translation>
        </message>
        <message>
            <source>Unfinished: %1 of %2 layers are carved</source>
            <translation>Не закончено: вырезано слоёв %1 из %2</translation>
        </message>
        <message>
            <source>Unfinished: %1 of %2 layers of %3 are carved</source>
            <translation>Не закончено: «%3», вырезано слоёв %1 из %2</translation>
        </message>
        <message>
            <source>Unfinished: a part of the first of %1 layers is carved</source>
            <translation>Не закончено: вырезана часть первого из слоёв: %1</translation>
        </message>
        <message>
            <source>Unit</source>
            <translation>Единица</translation>
        </message>
        <message>
            <source>Unrolled</source>
            <translation>Развёртка</translation>
        </message>
        <message>
            <source>Unrolled Ψ–Y map:</source>
            <translation>Развёртка Ψ–Y:</translation>
        </message>
        <message>
            <source>Up axis</source>
            <translation>Ось вверх</translation>
        </message>
        <message>
            <source>Up to %1 roughing passes of all layers</source>
            <translation>До %1 черновых проходов по всем слоям</translation>
        </message>
        <message>
            <source>Up to %1 roughing passes, layers %2 mm apart</source>
            <translation>До %1 черновых проходов, слои через %2 mm</translation>
        </message>
        <message>
            <source>Use the core's profile</source>
            <translation>Взять профиль ядра</translation>
        </message>
        <message>
            <source>Use the switch on the machine to stop it</source>
            <translation>Остановите станок его кнопкой</translation>
        </message>
        <message>
            <source>Use the wired emergency stop, or the machine's own switch</source>
            <translation>Нажмите проводной аварийный останов или выключатель станка</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Значение</translation>
        </message>
        <message>
            <source>Values that need a restart (↻): %1.</source>
            <translation>Значений, которым нужен перезапуск (↻): %1.</translation>
        </message>
        <message>
            <source>Verification</source>
            <translation>Сверка</translation>
        </message>
        <message>
            <source>Verification found a difference</source>
            <translation>Сверка нашла отличие</translation>
        </message>
        <message>
            <source>Verification found a difference: %1</source>
            <translation>Сверка нашла отличие: %1</translation>
        </message>
        <message>
            <source>Verified</source>
            <translation>Проверено</translation>
        </message>
        <message>
            <source>Verified as far as it was recorded, largest deviation %1 pulses</source>
            <translation>Сверено до конца записи, наибольшее отклонение %1 имп.</translation>
        </message>
        <message>
            <source>Verified: the pins carve the job, largest deviation %1 pulses</source>
            <translation>Сверено: выводы режут задание, наибольшее отклонение %1 имп.</translation>
        </message>
        <message>
            <source>Verified: the pulses of a dry run, which carves nothing</source>
            <translation>Сверено: импульсы холостого прогона, он ничего не режет</translation>
        </message>
        <message>
            <source>Verify</source>
            <translation>Сверить</translation>
        </message>
        <message>
            <source>Verify a trace…</source>
            <translation>Сверить трассу…</translation>
        </message>
        <message>
            <source>Verify: add its job first</source>
            <translation>Сверка: сначала добавьте задание</translation>
        </message>
        <message>
            <source>Verifying %1</source>
            <translation>Сверяю %1</translation>
        </message>
        <message>
            <source>View</source>
            <translation>Вид</translation>
        </message>
        <message>
            <source>Volume</source>
            <translation>Объём</translation>
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
            <source>Wear of the tool of %1</source>
            <translation>Износ инструмента %1</translation>
        </message>
        <message>
            <source>What</source>
            <translation>Что</translation>
        </message>
        <message>
            <source>What becomes of it</source>
            <translation>Что получится</translation>
        </message>
        <message>
            <source>What happened</source>
            <translation>Что произошло</translation>
        </message>
        <message>
            <source>What is wrong with the program; a click goes to the line</source>
            <translation>Что не так в программе; щелчок ведёт к строке</translation>
        </message>
        <message>
            <source>What keeps ticks in time</source>
            <translation>От чего зависят такты</translation>
        </message>
        <message>
            <source>What roughing leaves for the finishing pass</source>
            <translation>Что черновая обработка оставляет чистовому проходу</translation>
        </message>
        <message>
            <source>What roughing leaves for the finishing pass, along the radius.</source>
            <translation>Что черновая обработка оставляет чистовому проходу, по радиусу.</translation>
        </message>
        <message>
            <source>What the job and its tool will leave, and how far it is from the model</source>
            <translation>Что оставят задание и его инструмент и насколько это далеко от модели</translation>
        </message>
        <message>
            <source>What the map shows</source>
            <translation>Что показывает развёртка</translation>
        </message>
        <message>
            <source>What the mesh is made of, what is wrong with it and what no tool reaches</source>
            <translation>Из чего состоит сетка, что с ней не так и куда не достаёт ни один инструмент</translation>
        </message>
        <message>
            <source>What to do</source>
            <translation>Что делать</translation>
        </message>
        <message>
            <source>What was measured so far is the result</source>
            <translation>Измеренное до сих пор и есть результат</translation>
        </message>
        <message>
            <source>Where %1 is shown to stand</source>
            <translation>Показанное положение %1</translation>
        </message>
        <message>
            <source>Where the blank's axis stands off the table's, towards direction 0°</source>
            <translation>Смещение оси заготовки от оси стола в сторону 0°</translation>
        </message>
        <message>
            <source>Where the blank's axis stands off the table's, towards direction 90°</source>
            <translation>Смещение оси заготовки от оси стола в сторону 90°</translation>
        </message>
        <message>
            <source>Where the cylinder's axis stands off the table's, towards direction 0.</source>
            <translation>Смещение оси цилиндра от оси стола в сторону направления 0.</translation>
        </message>
        <message>
            <source>Where the cylinder's axis stands off the table's, towards direction 90.</source>
            <translation>Смещение оси цилиндра от оси стола в сторону направления 90.</translation>
        </message>
        <message>
            <source>Where the leftmost of the drawing's lines stands</source>
            <translation>Где стоит самое левое место линий чертежа</translation>
        </message>
        <message>
            <source>Where the picture's left and right edges meet</source>
            <translation>Где сходятся левый и правый края изображения</translation>
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
            <source>While a recording is shown</source>
            <translation>При показе записи</translation>
        </message>
        <message>
            <source>While keys are armed (F9)</source>
            <translation>Когда клавиши включены (F9)</translation>
        </message>
        <message>
            <source>Wiring test</source>
            <translation>Проверка проводки</translation>
        </message>
        <message>
            <source>Wiring test, recording pins…</source>
            <translation>Проверка проводки, запись выводов…</translation>
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
            <source>With those before</source>
            <translation>С предыдущими</translation>
        </message>
        <message>
            <source>Within a pulse %1 % of the surface, removed %2 cm³</source>
            <translation>С точностью до импульса %1 % поверхности, снято %2 см³</translation>
        </message>
        <message>
            <source>Working the expected piece out</source>
            <translation>Расчёт ожидаемой детали</translation>
        </message>
        <message>
            <source>Working the piece out was cancelled</source>
            <translation>Расчёт детали отменён</translation>
        </message>
        <message>
            <source>Working the piece out: %1 %</source>
            <translation>Деталь вычисляется: %1 %</translation>
        </message>
        <message>
            <source>Write</source>
            <translation>Записать</translation>
        </message>
        <message>
            <source>Write: nothing was measured</source>
            <translation>Записать: ничего не измерено</translation>
        </message>
        <message>
            <source>Write: step %1 cannot be</source>
            <translation>Записать: шаг %1 невозможен</translation>
        </message>
        <message>
            <source>Write: the machine moves</source>
            <translation>Записать: станок движется</translation>
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
            <source>Y goes to %1 mm.</source>
            <translation>Y идёт на %1 mm.</translation>
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
            <source>Zero of %1: %2</source>
            <translation>Ноль %1: %2</translation>
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
            <source>[ has no ]</source>
            <translation>у [ нет ]</translation>
        </message>
        <message>
            <source>[ is missing</source>
            <translation>нет [</translation>
        </message>
        <message>
            <source>a %1 drawing, which is not read; save it as %2</source>
            <translation>чертёж %1, который не читается; сохраните его как %2</translation>
        </message>
        <message>
            <source>a %1 model, which is not read; save it as STL or 3MF</source>
            <translation>модель %1, которая не читается; сохраните её как STL или 3MF</translation>
        </message>
        <message>
            <source>a %1 picture, which is not read; save it as PNG</source>
            <translation>изображение %1, которое не читается; сохраните его как PNG</translation>
        </message>
        <message>
            <source>a BMP picture of OS/2's kind, which is not read</source>
            <translation>изображение BMP типа OS/2, такие не читаются</translation>
        </message>
        <message>
            <source>a BMP picture of a kind that is not read (%1 bits, compression %2); save it as PNG</source>
            <translation>изображение BMP такого вида не читается (%1 бит, сжатие %2); сохраните его как PNG</translation>
        </message>
        <message>
            <source>a SPLINE whose knots and points do not belong together is left out.</source>
            <translation>SPLINE, узлы и точки которого не подходят друг другу, пропущен.</translation>
        </message>
        <message>
            <source>a TIFF picture of %1 bits a sample: 8 or 16 are read</source>
            <translation>изображение TIFF с %1 битами на отсчёт: читаются 8 или 16</translation>
        </message>
        <message>
            <source>a TIFF picture of a kind that is not read (%1 samples of %2 bits, photometric %3); save it as PNG</source>
            <translation>изображение TIFF такого вида не читается (отсчётов %1 по %2 бит, photometric %3); сохраните его как PNG</translation>
        </message>
        <message>
            <source>a TIFF picture of signed or floating numbers; save it with 8 or 16 bits</source>
            <translation>изображение TIFF со знаковыми или дробными числами; сохраните его с 8 или 16 битами</translation>
        </message>
        <message>
            <source>a TIFF picture that is packed in a way that is not read (compression %1); save it as PNG</source>
            <translation>изображение TIFF, сжатое способом, который не читается (сжатие %1); сохраните его как PNG</translation>
        </message>
        <message>
            <source>a TIFF picture whose samples are of different sizes; save it as PNG</source>
            <translation>изображение TIFF с отсчётами разного размера; сохраните его как PNG</translation>
        </message>
        <message>
            <source>a binary DXF drawing; save it as text (ASCII DXF)</source>
            <translation>двоичный чертёж DXF; сохраните его текстом (ASCII DXF)</translation>
        </message>
        <message>
            <source>a block holds words, comments, / and %</source>
            <translation>в кадре бывают слова, комментарии, / и %</translation>
        </message>
        <message>
            <source>a block of more than 100000 holes and pecks</source>
            <translation>кадр с более чем 100000 отверстий и заходов</translation>
        </message>
        <message>
            <source>a comment begins within a comment</source>
            <translation>комментарий начинается внутри комментария</translation>
        </message>
        <message>
            <source>a control character in the text; remove it</source>
            <translation>в тексте управляющий символ; удалите его</translation>
        </message>
        <message>
            <source>a coordinate is not a finite number</source>
            <translation>координата — не конечное число</translation>
        </message>
        <message>
            <source>a cycle is done 1 to 100000 times</source>
            <translation>цикл выполняется от 1 до 100000 раз</translation>
        </message>
        <message>
            <source>a cycle moves X, Y and Z alone</source>
            <translation>цикл движет только X, Y и Z</translation>
        </message>
        <message>
            <source>a cycle while %1 holds</source>
            <translation>цикл при действующем %1</translation>
        </message>
        <message>
            <source>a cycle while G93 holds</source>
            <translation>цикл при действующем G93</translation>
        </message>
        <message>
            <source>a cylinder's radius of less than 0</source>
            <translation>радиус цилиндра меньше 0</translation>
        </message>
        <message>
            <source>a damaged %1 picture</source>
            <translation>повреждённое изображение %1</translation>
        </message>
        <message>
            <source>a damaged %1 picture: %2</source>
            <translation>повреждённое изображение %1: %2</translation>
        </message>
        <message>
            <source>a damaged %1 picture: the file ends too early</source>
            <translation>повреждённое изображение %1: файл обрывается</translation>
        </message>
        <message>
            <source>a damaged BMP picture: its pixels are said to begin at byte %1, inside its head of %2</source>
            <translation>повреждённое изображение BMP: его точки будто бы начинаются с байта %1, внутри заголовка из %2</translation>
        </message>
        <message>
            <source>a damaged TIFF picture: its directory cannot be read</source>
            <translation>повреждённое изображение TIFF: его каталог не читается</translation>
        </message>
        <message>
            <source>a damaged TIFF picture: its pixels cannot be unpacked</source>
            <translation>повреждённое изображение TIFF: его точки не распаковываются</translation>
        </message>
        <message>
            <source>a date or time</source>
            <translation>дата или время</translation>
        </message>
        <message>
            <source>a division by 0</source>
            <translation>деление на 0</translation>
        </message>
        <message>
            <source>a drawing without a width goes not all round</source>
            <translation>чертёж без ширины не обойдёт весь оборот</translation>
        </message>
        <message>
            <source>a drawn way is carved as with "path"</source>
            <translation>начерченный путь режется как при "path"</translation>
        </message>
        <message>
            <source>a dwell of %1 s; the machine takes %2 s, a day, at most</source>
            <translation>выдержка %1 s; станок может не больше %2 s, суток</translation>
        </message>
        <message>
            <source>a dwell of less than 0 s</source>
            <translation>выдержка меньше 0 s</translation>
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
            <source>a job runs (%1); stop it or wait for its end</source>
            <translation>задание выполняется (%1); остановите его или дождитесь конца</translation>
        </message>
        <message>
            <source>a layer has %1 points: no carving begins beyond them, nor with its last</source>
            <translation>точек в слое: %1; начать за ними или с последней из них нельзя</translation>
        </message>
        <message>
            <source>a layer is a whole number</source>
            <translation>номер слоя — целое число</translation>
        </message>
        <message>
            <source>a layer needs its height and at least two radii</source>
            <translation>слою нужны высота и не менее двух радиусов</translation>
        </message>
        <message>
            <source>a layer of one point goes nowhere; it needs two</source>
            <translation>слой из одной точки никуда не ведёт; нужны две</translation>
        </message>
        <message>
            <source>a layer sweeps %1 pulses of Ψ, half a revolution of this machine is %2; slice the model for this machine's profile</source>
            <translation>слой занимает %1 импульсов Ψ, а пол-оборота этого станка — %2; нарежьте модель для профиля этого станка</translation>
        </message>
        <message>
            <source>a line is carved as with "path": both heads move</source>
            <translation>прямая режется как при "path": движутся обе головки</translation>
        </message>
        <message>
            <source>a line is carved as with "path": psi turns</source>
            <translation>прямая режется как при "path": вращается psi</translation>
        </message>
        <message>
            <source>a move that cuts, and the feed is 0</source>
            <translation>рабочее перемещение, а подача 0</translation>
        </message>
        <message>
            <source>a move under G93 without F</source>
            <translation>перемещение при G93 без F</translation>
        </message>
        <message>
            <source>a move under G95, and no spindle speed</source>
            <translation>перемещение при G95, а скорости шпинделя нет</translation>
        </message>
        <message>
            <source>a name without letters</source>
            <translation>имя без букв</translation>
        </message>
        <message>
            <source>a negative number to a power that is not whole</source>
            <translation>отрицательное число в нецелой степени</translation>
        </message>
        <message>
            <source>a number</source>
            <translation>число</translation>
        </message>
        <message>
            <source>a number alone begins a subroutine for M98, within another block</source>
            <translation>число само по себе начинает подпрограмму для M98, а стоит внутри другого блока</translation>
        </message>
        <message>
            <source>a number of more than 1000000000</source>
            <translation>число больше 1000000000</translation>
        </message>
        <message>
            <source>a number that no machine has</source>
            <translation>число, которого нет ни у одного станка</translation>
        </message>
        <message>
            <source>a number with a fraction</source>
            <translation>число с дробной частью</translation>
        </message>
        <message>
            <source>a packed file (gzip), as SVGZ is; unpack it first</source>
            <translation>сжатый файл (gzip), как SVGZ; сначала распакуйте его</translation>
        </message>
        <message>
            <source>a page that was taken away stops the tick until it is back; a real machine is refused</source>
            <translation>вытесненная страница останавливает такт до возврата; настоящий станок не запускается</translation>
        </message>
        <message>
            <source>a parameter stands here, and sets nothing</source>
            <translation>здесь стоит параметр и ничего не задаёт</translation>
        </message>
        <message>
            <source>a peck is more than 0 deep</source>
            <translation>глубина захода должна быть больше 0</translation>
        </message>
        <message>
            <source>a picture %1 mm high would be %2 mm wide, and once round are only %3 mm: choose at most %4 mm of height, a larger diameter, or all round, which changes its shape</source>
            <translation>изображение высотой %1 mm имело бы ширину %2 mm, а окружность всего %3 mm: выберите высоту не более %4 mm, больший диаметр или полный оборот, который меняет пропорции</translation>
        </message>
        <message>
            <source>a picture of %1 x %2 pixels; at most 100 million can be read, and 65535 a side</source>
            <translation>изображение %1 x %2 пикселей; читается не более 100 миллионов и 65535 по стороне</translation>
        </message>
        <message>
            <source>a picture without pixels</source>
            <translation>изображение без пикселей</translation>
        </message>
        <message>
            <source>a place</source>
            <translation>место</translation>
        </message>
        <message>
            <source>a place beyond 1 000 000 000 mm</source>
            <translation>место дальше 1 000 000 000 mm</translation>
        </message>
        <message>
            <source>a point</source>
            <translation>остриё</translation>
        </message>
        <message>
            <source>a point carves every layer, whatever the stepover; choose a tool</source>
            <translation>остриё режет каждый слой, каким бы ни был шаг слоёв; выберите инструмент</translation>
        </message>
        <message>
            <source>a point leaves nothing, so there is no draft; slice first</source>
            <translation>остриё ничего не оставляет, наброска нет; сначала нарежьте</translation>
        </message>
        <message>
            <source>a processor that first speeds up makes ticks late</source>
            <translation>процессор, который сначала разгоняется, задерживает такты</translation>
        </message>
        <message>
            <source>a published job is being looked at; start once it is accepted</source>
            <translation>опубликованное задание ещё проверяется; запускайте, когда оно будет принято</translation>
        </message>
        <message>
            <source>a pulse, its gap and the writes take %1 us, more than a tick of %2 us; lengthen tick.period_us, shorten port.step_high_ns or port.step_low_ns, or set port.pulses = "over-ticks"</source>
            <translation>импульс, пауза и запись в порт занимают %1 us, больше такта в %2 us; увеличьте tick.period_us, сократите port.step_high_ns или port.step_low_ns или задайте port.pulses = "over-ticks"</translation>
        </message>
        <message>
            <source>a radius of %1 mm does not reach the end, which is %2 mm away</source>
            <translation>радиус %1 mm не достаёт до конца, до которого %2 mm</translation>
        </message>
        <message>
            <source>a record was refused</source>
            <translation>запись отвергнута</translation>
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
            <source>a stepdown of %1 makes more than %2 passes</source>
            <translation>шаг вглубь %1 даёт больше %2 проходов</translation>
        </message>
        <message>
            <source>a stepover of %1 is more than the tool is wide, %2</source>
            <translation>шаг слоёв %1 больше ширины инструмента, %2</translation>
        </message>
        <message>
            <source>a stop came after it; ask again</source>
            <translation>после неё пришла команда остановки; повторите</translation>
        </message>
        <message>
            <source>a stop of the program (M0); Resume goes on</source>
            <translation>останов программы (M0); «Продолжить» ведёт дальше</translation>
        </message>
        <message>
            <source>a string</source>
            <translation>строка</translation>
        </message>
        <message>
            <source>a subroutine within another block</source>
            <translation>подпрограмма внутри другого блока</translation>
        </message>
        <message>
            <source>a switch was tripped until just now; try again</source>
            <translation>концевик был замкнут до последнего мгновения; повторите</translation>
        </message>
        <message>
            <source>a table</source>
            <translation>таблица</translation>
        </message>
        <message>
            <source>a table of layers is no spiral: choose Joining continuous or zigzag</source>
            <translation>таблица слоёв — не спираль: выберите непрерывную связь слоёв или зигзаг</translation>
        </message>
        <message>
            <source>a text of %1 bytes; give %2 to %3 bytes</source>
            <translation>текст длиной %1 байт; допустимо от %2 до %3 байт</translation>
        </message>
        <message>
            <source>a tolerance of less than 0</source>
            <translation>допуск меньше 0</translation>
        </message>
        <message>
            <source>a tool change (M6); Resume goes on</source>
            <translation>смена инструмента (M6); «Продолжить» ведёт дальше</translation>
        </message>
        <message>
            <source>a tool does not become %1 mm shorter; 0 to %2 mm, else touch the head off anew</source>
            <translation>инструмент не становится короче на %1 mm; от 0 до %2 mm, иначе сделайте касание заново</translation>
        </message>
        <message>
            <source>a transform that cannot be read; the element is left out.</source>
            <translation>преобразование не читается; элемент пропущен.</translation>
        </message>
        <message>
            <source>a value is missing</source>
            <translation>нет значения</translation>
        </message>
        <message>
            <source>a virtual machine</source>
            <translation>виртуальная машина</translation>
        </message>
        <message>
            <source>a wait of less than 0 s</source>
            <translation>ожидание меньше 0 s</translation>
        </message>
        <message>
            <source>a way of %1 s; the machine takes %2 s, a day, at most</source>
            <translation>путь длится %1 s; станок может не больше %2 s, суток</translation>
        </message>
        <message>
            <source>a way of more than 100000 chords</source>
            <translation>путь более чем из 100000 хорд</translation>
        </message>
        <message>
            <source>a whole number</source>
            <translation>целое число</translation>
        </message>
        <message>
            <source>about %1</source>
            <translation>около %1</translation>
        </message>
        <message>
            <source>about %1 % of the surface</source>
            <translation>около %1 % поверхности</translation>
        </message>
        <message>
            <source>about %1 left</source>
            <translation>ещё около %1</translation>
        </message>
        <message>
            <source>add the word</source>
            <translation>добавьте это слово</translation>
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
            <source>all radii are the core radius of %1 mm: nothing but a plain rod would be carved; larger radii, or a smaller core_radius_mm, carve more</source>
            <translation>все радиусы равны радиусу сердцевины %1 mm: получился бы только гладкий стержень; нужны большие радиусы или меньший core_radius_mm</translation>
        </message>
        <message>
            <source>allow it: a line "@GROUP - rtprio 90" in /etc/security/limits.d and a new login, or the capability CAP_SYS_NICE; in a container, real-time time for its control group</source>
            <translation>разрешите: строка "@GROUP - rtprio 90" в /etc/security/limits.d и новый вход, или право CAP_SYS_NICE; в контейнере — время реального времени для его группы</translation>
        </message>
        <message>
            <source>allow writing to /dev/cpu_dma_latency: a udev rule KERNEL=="cpu_dma_latency", GROUP="GROUP", MODE="0660", and be in that group</source>
            <translation>разрешите запись в /dev/cpu_dma_latency: правило udev KERNEL=="cpu_dma_latency", GROUP="GROUP", MODE="0660" и членство в этой группе</translation>
        </message>
        <message>
            <source>allowed by CAP_IPC_LOCK</source>
            <translation>разрешено CAP_IPC_LOCK</translation>
        </message>
        <message>
            <source>allowed by CAP_SYS_NICE</source>
            <translation>разрешено CAP_SYS_NICE</translation>
        </message>
        <message>
            <source>allowed by CAP_SYS_RAWIO</source>
            <translation>разрешено CAP_SYS_RAWIO</translation>
        </message>
        <message>
            <source>an O word stands behind other words</source>
            <translation>слово O стоит после других слов</translation>
        </message>
        <message>
            <source>an arc has 1 to 1000000 turns</source>
            <translation>у дуги от 1 до 1000000 оборотов</translation>
        </message>
        <message>
            <source>an arc in %1 does not move Y and one head</source>
            <translation>дуга в %1 не движет Y и одну головку</translation>
        </message>
        <message>
            <source>an arc in %1 of a system that is rotated</source>
            <translation>дуга в %1 в повёрнутой системе координат</translation>
        </message>
        <message>
            <source>an arc of more than 100000 chords</source>
            <translation>дуга более чем из 100000 хорд</translation>
        </message>
        <message>
            <source>an arc stays chords: another axis moves with it</source>
            <translation>дуга остаётся хордами: с ней движется ещё одна ось</translation>
        </message>
        <message>
            <source>an arc stays chords: both heads draw it</source>
            <translation>дуга остаётся хордами: её чертят обе головки</translation>
        </message>
        <message>
            <source>an arc stays chords: it comes within two pulses of the end of a travel or of the core</source>
            <translation>дуга остаётся хордами: она ближе двух импульсов к концу хода или к сердцевине</translation>
        </message>
        <message>
            <source>an arc stays chords: its ends are not, to a pulse, as far from the centre as each other</source>
            <translation>дуга остаётся хордами: её концы с точностью до импульса не одинаково далеки от центра</translation>
        </message>
        <message>
            <source>an arc stays chords: its ends differ and are within 16 pulses of each other</source>
            <translation>дуга остаётся хордами: её концы различны, но ближе 16 импульсов друг к другу</translation>
        </message>
        <message>
            <source>an arc stays chords: its head and y differ in pulses per mm</source>
            <translation>дуга остаётся хордами: у её головки и y разное число импульсов на mm</translation>
        </message>
        <message>
            <source>an arc stays chords: its radius is below 16 pulses</source>
            <translation>дуга остаётся хордами: её радиус меньше 16 импульсов</translation>
        </message>
        <message>
            <source>an arc stays chords: its radius is too large</source>
            <translation>дуга остаётся хордами: её радиус слишком велик</translation>
        </message>
        <message>
            <source>an arc takes R1 and Y, or R2 and Y</source>
            <translation>для дуги нужны R1 и Y или R2 и Y</translation>
        </message>
        <message>
            <source>an array</source>
            <translation>массив</translation>
        </message>
        <message>
            <source>an array of two numbers</source>
            <translation>массив из двух чисел</translation>
        </message>
        <message>
            <source>an axis word stands beside %1</source>
            <translation>слово оси стоит рядом с %1</translation>
        </message>
        <message>
            <source>an expression stands here without a letter</source>
            <translation>здесь выражение без буквы</translation>
        </message>
        <message>
            <source>an input cannot be on pin %1, which is an output; use pin 10 to 13 or 15</source>
            <translation>вход не может быть на выводе %1: это выход; возьмите вывод от 10 до 13 или 15</translation>
        </message>
        <message>
            <source>an offset beyond 1 000 000 000 mm or degrees</source>
            <translation>смещение больше 1 000 000 000 mm или градусов</translation>
        </message>
        <message>
            <source>an optional stop (M1); Resume goes on</source>
            <translation>останов по выбору (M1); «Продолжить» ведёт дальше</translation>
        </message>
        <message>
            <source>an output cannot be on pin %1, which is an input; use pin 1 to 9, 14, 16 or 17</source>
            <translation>выход не может быть на выводе %1: это вход; возьмите вывод от 1 до 9, 14, 16 или 17</translation>
        </message>
        <message>
            <source>an output is being tested; end the test first</source>
            <translation>проверяется выход; сначала закончите проверку</translation>
        </message>
        <message>
            <source>another code stands beside %1</source>
            <translation>другой код стоит рядом с %1</translation>
        </message>
        <message>
            <source>another job was carved last</source>
            <translation>в последний раз вырезалось другое задание</translation>
        </message>
        <message>
            <source>another job was published meanwhile; publish this one again</source>
            <translation>тем временем опубликовано другое задание; опубликуйте это снова</translation>
        </message>
        <message>
            <source>another process has the pins recorded, or this core cannot record them</source>
            <translation>выводы записывает другой процесс, или это ядро не может их записывать</translation>
        </message>
        <message>
            <source>another process has the work offsets, as the one that runs a program has; wait for its end, or stop it</source>
            <translation>рабочие смещения заняты другим процессом, например исполняющим программу; дождитесь его конца или остановите его</translation>
        </message>
        <message>
            <source>another program is being sent (process %1); wait for its end</source>
            <translation>передаётся другая программа (процесс %1); дождитесь её конца</translation>
        </message>
        <message>
            <source>another run than that of the layer's first point</source>
            <translation>другой run, чем у первой точки слоя</translation>
        </message>
        <message>
            <source>any processor</source>
            <translation>любой процессор</translation>
        </message>
        <message>
            <source>any program may keep the tick waiting; a real machine is refused</source>
            <translation>любая программа может задержать такт; настоящий станок не запускается</translation>
        </message>
        <message>
            <source>arc, from the head's + to Y's +</source>
            <translation>дуга, от + головки к + Y</translation>
        </message>
        <message>
            <source>arc, the other way</source>
            <translation>дуга, в другую сторону</translation>
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
            <source>as it is</source>
            <translation>как есть</translation>
        </message>
        <message>
            <source>as its shape</source>
            <translation>по форме</translation>
        </message>
        <message>
            <source>as planned</source>
            <translation>по плану</translation>
        </message>
        <message>
            <source>as the blank</source>
            <translation>по заготовке</translation>
        </message>
        <message>
            <source>as the profile</source>
            <translation>по профилю</translation>
        </message>
        <message>
            <source>assumed</source>
            <translation>предположен</translation>
        </message>
        <message>
            <source>at X %1 C %2 mm the tip of %3 comes to %4 mm, and the core that it must not reach ends at %5 mm</source>
            <translation>у X %1 C %2 mm остриё %3 приходит в %4 mm, а сердцевина, в которую нельзя заходить, кончается на %5 mm</translation>
        </message>
        <message>
            <source>at X %1 C %2 mm the way passes the axis</source>
            <translation>у X %1 C %2 mm путь проходит через ось</translation>
        </message>
        <message>
            <source>at least %1</source>
            <translation>не меньше %1</translation>
        </message>
        <message>
            <source>at most %1 KiB</source>
            <translation>не больше %1 КиБ</translation>
        </message>
        <message>
            <source>auto</source>
            <translation>авто</translation>
        </message>
        <message>
            <source>axes or surface</source>
            <translation>axes или surface</translation>
        </message>
        <message>
            <source>axis %1</source>
            <translation>ось %1</translation>
        </message>
        <message>
            <source>axis %1 would need %2 pulses/s, but the tick and the pulse times allow %3 pulses/s; lower it to %4, or shorten tick.period_us, port.step_high_ns or port.step_low_ns</source>
            <translation>оси %1 нужно %2 импульсов/с, но такт и времена импульса допускают %3 импульсов/с; уменьшите до %4 или сократите tick.period_us, port.step_high_ns или port.step_low_ns</translation>
        </message>
        <message>
            <source>axis %1 would need %2 pulses/s, but the two-timer schedule allows %3 pulses/s; lower it to %4, or shorten tick.io_us</source>
            <translation>оси %1 нужно %2 импульсов/с, но схема two-timer допускает %3 импульсов/с; уменьшите до %4 или сократите tick.io_us</translation>
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
            <source>ball</source>
            <translation>шаровой</translation>
        </message>
        <message>
            <source>be in the group that owns it: adduser USER %1, and a new login</source>
            <translation>войдите в группу-владельца: adduser USER %1, и новый вход</translation>
        </message>
        <message>
            <source>became shorter while it was read</source>
            <translation>стал короче во время чтения</translation>
        </message>
        <message>
            <source>before finishing</source>
            <translation>перед чистовой</translation>
        </message>
        <message>
            <source>begin and end of the arc are not equally far from its centre, or it is too small</source>
            <translation>начало и конец дуги не на равном расстоянии от её центра, или дуга слишком мала</translation>
        </message>
        <message>
            <source>begin and end with one number or name, one block within the other</source>
            <translation>начинайте и кончайте одним номером или именем, один блок внутри другого</translation>
        </message>
        <message>
            <source>being made</source>
            <translation>составляется</translation>
        </message>
        <message>
            <source>being published</source>
            <translation>передаётся</translation>
        </message>
        <message>
            <source>being read</source>
            <translation>читается</translation>
        </message>
        <message>
            <source>being sliced</source>
            <translation>нарезается</translation>
        </message>
        <message>
            <source>beyond the machine's limits</source>
            <translation>за пределами станка</translation>
        </message>
        <message>
            <source>blank</source>
            <translation>заготовка</translation>
        </message>
        <message>
            <source>blank ⌀ %1 mm</source>
            <translation>заготовка ⌀ %1 mm</translation>
        </message>
        <message>
            <source>blended</source>
            <translation>плавный</translation>
        </message>
        <message>
            <source>bodies inside out: %1</source>
            <translation>тел наизнанку: %1</translation>
        </message>
        <message>
            <source>both ways between the marks are needed</source>
            <translation>нужны оба расстояния между метками</translation>
        </message>
        <message>
            <source>box centre</source>
            <translation>центр</translation>
        </message>
        <message>
            <source>brackets and signs in 64 levels</source>
            <translation>скобки и знаки в 64 уровня</translation>
        </message>
        <message>
            <source>bring X and C to known places first, with X 0 on the axis, no rotation and both tips of one X alike</source>
            <translation>сначала приведите X и C в известные места: X 0 на оси, без поворота, оба острия одного X одинаково</translation>
        </message>
        <message>
            <source>built-in profile</source>
            <translation>встроенный профиль</translation>
        </message>
        <message>
            <source>can be kept shallow</source>
            <translation>можно держать неглубоким</translation>
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
            <source>cannot be written</source>
            <translation>не удаётся записать</translation>
        </message>
        <message>
            <source>carries no job; open its job first</source>
            <translation>не содержит задания; сначала откройте его</translation>
        </message>
        <message>
            <source>carries several jobs; open the one that is meant</source>
            <translation>содержит несколько заданий; откройте нужное</translation>
        </message>
        <message>
            <source>carved</source>
            <translation>вырезано</translation>
        </message>
        <message>
            <source>carved (%1 layers not seen: as planned)</source>
            <translation>вырезано (слоёв не видно: %1, по плану)</translation>
        </message>
        <message>
            <source>carved to the last point</source>
            <translation>вырезано до последней точки</translation>
        </message>
        <message>
            <source>carved, as planned</source>
            <translation>вырезано, по плану</translation>
        </message>
        <message>
            <source>carving</source>
            <translation>резьба</translation>
        </message>
        <message>
            <source>catching up</source>
            <translation>изображение догоняет</translation>
        </message>
        <message>
            <source>catching up: %1 layers</source>
            <translation>изображение догоняет, слоёв осталось: %1</translation>
        </message>
        <message>
            <source>centroid</source>
            <translation>центроид</translation>
        </message>
        <message>
            <source>checked</source>
            <translation>проверено</translation>
        </message>
        <message>
            <source>clipping and masks are not followed: &lt;%1&gt; is carved whole.</source>
            <translation>обрезка и маски не учитываются: &lt;%1&gt; вырезается целиком.</translation>
        </message>
        <message>
            <source>clock</source>
            <translation>часы</translation>
        </message>
        <message>
            <source>close every [ with ], and every &lt; of a name with &gt;</source>
            <translation>закройте каждую [ знаком ], а каждую &lt; имени знаком &gt;</translation>
        </message>
        <message>
            <source>closed, all facets turned alike</source>
            <translation>замкнута, все грани повёрнуты одинаково</translation>
        </message>
        <message>
            <source>column %1: %2 mm, but the heads clear no more than %3 mm</source>
            <translation>столбец %1: %2 mm, а головки обходят не более %3 mm</translation>
        </message>
        <message>
            <source>column %1: a pass has no such length</source>
            <translation>столбец %1: у прохода не бывает такого размера</translation>
        </message>
        <message>
            <source>computer</source>
            <translation>компьютер</translation>
        </message>
        <message>
            <source>content of the model's file</source>
            <translation>содержимое файла модели</translation>
        </message>
        <message>
            <source>continuous</source>
            <translation>непрерывно</translation>
        </message>
        <message>
            <source>continuous, zigzag or spiral</source>
            <translation>continuous, zigzag или spiral</translation>
        </message>
        <message>
            <source>core lost</source>
            <translation>ядро потеряно</translation>
        </message>
        <message>
            <source>counter-clockwise, seen from the axis' positive end</source>
            <translation>против часовой стрелки, если смотреть с положительного конца оси</translation>
        </message>
        <message>
            <source>cpupower frequency-set --governor performance (package linux-cpupower)</source>
            <translation>cpupower frequency-set --governor performance (пакет linux-cpupower)</translation>
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
            <source>docs/gcode.md says which ways run step by step</source>
            <translation>какие пути идут по шагам, сказано в docs/gcode.md</translation>
        </message>
        <message>
            <source>done</source>
            <translation>готово</translation>
        </message>
        <message>
            <source>doubled: %1</source>
            <translation>повторов: %1</translation>
        </message>
        <message>
            <source>draw arcs in Y and one head: G17 or G19, with the letters of lathes G18</source>
            <translation>чертите дуги в Y и одной головке: G17 или G19, с буквами токарных станков G18</translation>
        </message>
        <message>
            <source>drive a real machine from a real computer</source>
            <translation>управляйте настоящим станком с настоящего компьютера</translation>
        </message>
        <message>
            <source>drives off</source>
            <translation>приводы отключены</translation>
        </message>
        <message>
            <source>drives-off</source>
            <translation>выключить приводы</translation>
        </message>
        <message>
            <source>dry run to the last point: nothing was carved</source>
            <translation>холостой прогон до последней точки: ничего не вырезано</translation>
        </message>
        <message>
            <source>edges between flipped facets: %1</source>
            <translation>рёбер между вывернутыми гранями: %1</translation>
        </message>
        <message>
            <source>emergency stop</source>
            <translation>аварийный останов</translation>
        </message>
        <message>
            <source>emergency stop by the operator</source>
            <translation>аварийный останов оператором</translation>
        </message>
        <message>
            <source>end the block before the program ends</source>
            <translation>закончите блок до конца программы</translation>
        </message>
        <message>
            <source>end the comment with ) on its line</source>
            <translation>закончите комментарий знаком ) в его строке</translation>
        </message>
        <message>
            <source>end the mode first, with G7.1 C0 or G13.1</source>
            <translation>сначала закончите режим: G7.1 C0 или G13.1</translation>
        </message>
        <message>
            <source>end the program that holds it; psicarve status shows a core</source>
            <translation>завершите программу, которая его держит; psicarve status показывает ядро</translation>
        </message>
        <message>
            <source>end the program with M2 or M30, or frame it with two lines of %</source>
            <translation>закончите программу M2 или M30 либо заключите её между двумя строками с %</translation>
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
            <source>entries of the flight recorder</source>
            <translation>записей самописца</translation>
        </message>
        <message>
            <source>feed</source>
            <translation>подача</translation>
        </message>
        <message>
            <source>feed %1 %</source>
            <translation>подача %1 %</translation>
        </message>
        <message>
            <source>feed %1 mm/s</source>
            <translation>подача %1 mm/s</translation>
        </message>
        <message>
            <source>feed [mm/s]</source>
            <translation>подача [mm/s]</translation>
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
            <source>finishing only</source>
            <translation>только чистовая</translation>
        </message>
        <message>
            <source>finishing pass</source>
            <translation>чистовой</translation>
        </message>
        <message>
            <source>fit a parallel port; modprobe parport_pc ppdev</source>
            <translation>установите параллельный порт; modprobe parport_pc ppdev</translation>
        </message>
        <message>
            <source>flat</source>
            <translation>плоский</translation>
        </message>
        <message>
            <source>flight recorder, entry %1, counted from 0</source>
            <translation>самописец, запись %1, счёт с 0</translation>
        </message>
        <message>
            <source>forget</source>
            <translation>забыть</translation>
        </message>
        <message>
            <source>free</source>
            <translation>свободен</translation>
        </message>
        <message>
            <source>from here on a tick may have been missed</source>
            <translation>отсюда такт мог быть пропущен</translation>
        </message>
        <message>
            <source>from standard input</source>
            <translation>из стандартного ввода</translation>
        </message>
        <message>
            <source>from the pins</source>
            <translation>с выводов</translation>
        </message>
        <message>
            <source>give --cpu the number of a processor that this process may use, or any</source>
            <translation>задайте --cpu номер доступного процессора или any</translation>
        </message>
        <message>
            <source>give F before the first move that cuts</source>
            <translation>задайте F до первого рабочего перемещения</translation>
        </message>
        <message>
            <source>give F in every such block while G93 holds</source>
            <translation>задавайте F в каждом таком кадре, пока действует G93</translation>
        </message>
        <message>
            <source>give G0, G1, G2 or G3 first</source>
            <translation>сначала задайте G0, G1, G2 или G3</translation>
        </message>
        <message>
            <source>give G7.1 with its C, G12.1 and G13.1 a block of their own</source>
            <translation>дайте G7.1 с её C, G12.1 и G13.1 отдельный кадр</translation>
        </message>
        <message>
            <source>give R half the way to the end at least</source>
            <translation>задайте R не меньше половины расстояния до конца</translation>
        </message>
        <message>
            <source>give S first, or use G94</source>
            <translation>сначала задайте S или используйте G94</translation>
        </message>
        <message>
            <source>give a value that the word can have</source>
            <translation>задайте значение, которое слово может иметь</translation>
        </message>
        <message>
            <source>give an O word a line of its own</source>
            <translation>дайте слову O отдельную строку</translation>
        </message>
        <message>
            <source>give centre and end with more digits</source>
            <translation>задайте центр и конец с большим числом цифр</translation>
        </message>
        <message>
            <source>give each subroutine its own number or name</source>
            <translation>дайте каждой подпрограмме свой номер или имя</translation>
        </message>
        <message>
            <source>give it a value that can be calculated</source>
            <translation>задайте значение, которое можно вычислить</translation>
        </message>
        <message>
            <source>give one code of a modal group in a block</source>
            <translation>задавайте в кадре один код модальной группы</translation>
        </message>
        <message>
            <source>give the centre in the plane's two words, or R alone</source>
            <translation>задайте центр двумя словами плоскости или только R</translation>
        </message>
        <message>
            <source>give the centre with two of I, J and K, or the radius with R</source>
            <translation>задайте центр двумя из I, J и K или радиус через R</translation>
        </message>
        <message>
            <source>give the centre: R does not tell where a whole circle lies</source>
            <translation>задайте центр: по R не видно, где лежит полный круг</translation>
        </message>
        <message>
            <source>give the core real-time rights, lengthen tick.period_us or raise tick.missed_alarm_per_s</source>
            <translation>дайте ядру права реального времени, увеличьте tick.period_us или tick.missed_alarm_per_s</translation>
        </message>
        <message>
            <source>give the length itself with G43.1</source>
            <translation>задайте саму длину через G43.1</translation>
        </message>
        <message>
            <source>give the letter once in a block</source>
            <translation>задавайте букву в кадре один раз</translation>
        </message>
        <message>
            <source>granted</source>
            <translation>есть</translation>
        </message>
        <message>
            <source>grooves %1 mm deep and %2 mm wide; where no point meets the line, up to %3 mm wider along the layers and %4 mm across them</source>
            <translation>канавки глубиной %1 mm и шириной %2 mm; где точки не попадают на линию, до %3 mm шире вдоль слоёв и до %4 mm поперёк</translation>
        </message>
        <message>
            <source>grooves %1 mm deep; they must be deeper than 0, and less deep than the cylinder's radius of %2 mm</source>
            <translation>канавки глубиной %1 mm; нужно больше 0 и меньше радиуса цилиндра %2 mm</translation>
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
            <source>has been changed since it was read; decode it again</source>
            <translation>изменён после чтения; разберите его снова</translation>
        </message>
        <message>
            <source>has been changed while it is run; what was read of it before is run</source>
            <translation>изменён во время исполнения; исполняется прочитанное до этого</translation>
        </message>
        <message>
            <source>has no closed outline; the longest stroke goes from %1 to %2 mm, %3 apart; close it in the drawing program</source>
            <translation>нет замкнутого контура; самая длинная линия от %1 до %2 mm, разрыв %3; замкните её в графической программе</translation>
        </message>
        <message>
            <source>heap kept</source>
            <translation>куча удержана</translation>
        </message>
        <message>
            <source>height</source>
            <translation>высота</translation>
        </message>
        <message>
            <source>heights: %1 layers differ, the first is layer %2, counted from 0</source>
            <translation>высоты: отличаются слоёв %1, первый — %2, счёт с 0</translation>
        </message>
        <message>
            <source>held</source>
            <translation>пауза</translation>
        </message>
        <message>
            <source>held by %1</source>
            <translation>занято: %1</translation>
        </message>
        <message>
            <source>high</source>
            <translation>высокий</translation>
        </message>
        <message>
            <source>high or low</source>
            <translation>high или low</translation>
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
            <source>holds no line that can be carved (%1)</source>
            <translation>нет линий, которые можно вырезать (%1)</translation>
        </message>
        <message>
            <source>holes: %1, open edges: %2</source>
            <translation>дыр: %1, открытых рёбер: %2</translation>
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
            <source>in force</source>
            <translation>действует</translation>
        </message>
        <message>
            <source>in it</source>
            <translation>в записи</translation>
        </message>
        <message>
            <source>inches</source>
            <translation>дюймы</translation>
        </message>
        <message>
            <source>index or none</source>
            <translation>index или none</translation>
        </message>
        <message>
            <source>info</source>
            <translation>сведения</translation>
        </message>
        <message>
            <source>inside out</source>
            <translation>вывернута наизнанку</translation>
        </message>
        <message>
            <source>install a real-time kernel: apt install linux-image-rt-amd64</source>
            <translation>установите ядро реального времени: apt install linux-image-rt-amd64</translation>
        </message>
        <message>
            <source>interrupted; nothing has moved</source>
            <translation>прервано; ничего не сдвинулось</translation>
        </message>
        <message>
            <source>is a folder, not a model file</source>
            <translation>это папка, а не файл модели</translation>
        </message>
        <message>
            <source>is a folder; choose a program</source>
            <translation>это папка; выберите программу</translation>
        </message>
        <message>
            <source>is a zip archive, but holds no 3MF model</source>
            <translation>это архив zip, но без модели 3MF</translation>
        </message>
        <message>
            <source>is counted from the blank's surface, and nobody knows where that is; set blank.radius_mm</source>
            <translation>отсчитывается от поверхности заготовки, а где она, неизвестно; задайте blank.radius_mm</translation>
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
            <source>is no regular file, and is read twice</source>
            <translation>не обычный файл, а читается дважды</translation>
        </message>
        <message>
            <source>is not a regular file</source>
            <translation>не обычный файл</translation>
        </message>
        <message>
            <source>is not wired, but %1 = %2 needs it; give its pin, or set %3 = "none"</source>
            <translation>не подключён, но нужен для %1 = %2; укажите вывод или задайте %3 = "none"</translation>
        </message>
        <message>
            <source>is not wired, so axis %1 cannot move; give its pin</source>
            <translation>не подключён, и ось %1 не может двигаться; укажите вывод</translation>
        </message>
        <message>
            <source>isolated: %1; the tick takes %2</source>
            <translation>изолированы: %1; такт берёт %2</translation>
        </message>
        <message>
            <source>it has a character that is none to print; remove it</source>
            <translation>в тексте есть непечатаемый символ; удалите его</translation>
        </message>
        <message>
            <source>it said nothing</source>
            <translation>она ничего не сообщила</translation>
        </message>
        <message>
            <source>it was stopped in line %1; it can go on from there</source>
            <translation>остановлена в строке %1; с неё можно продолжить</translation>
        </message>
        <message>
            <source>its &lt;use&gt; elements draw more than two million elements</source>
            <translation>элементы &lt;use&gt; рисуют более двух миллионов элементов</translation>
        </message>
        <message>
            <source>its blocks draw more than a million elements</source>
            <translation>блоки рисуют более миллиона элементов</translation>
        </message>
        <message>
            <source>its blocks draw more than half a gigabyte of text</source>
            <translation>его блоки рисуют больше полугигабайта текста</translation>
        </message>
        <message>
            <source>its grooves are of another tool</source>
            <translation>его канавки для другого инструмента</translation>
        </message>
        <message>
            <source>its host takes the processor away when it likes, and nothing here can prevent that</source>
            <translation>хост забирает процессор когда хочет, и здесь этому не помешать</translation>
        </message>
        <message>
            <source>its next lines have not come; it goes on when they do</source>
            <translation>её следующие строки не пришли; она продолжит, когда они придут</translation>
        </message>
        <message>
            <source>its outlines cannot be joined: %1</source>
            <translation>контуры не удаётся объединить: %1</translation>
        </message>
        <message>
            <source>its outlines enclose no area; there is nothing to carve</source>
            <translation>контуры не охватывают площади; вырезать нечего</translation>
        </message>
        <message>
            <source>its reader is gone</source>
            <translation>её читатель исчез</translation>
        </message>
        <message>
            <source>its reader was gone</source>
            <translation>её читатель исчез</translation>
        </message>
        <message>
            <source>job</source>
            <translation>задание</translation>
        </message>
        <message>
            <source>jog</source>
            <translation>ручное перемещение</translation>
        </message>
        <message>
            <source>joining</source>
            <translation>соединение</translation>
        </message>
        <message>
            <source>journal of the machine, run %1</source>
            <translation>журнал станка, запуск %1</translation>
        </message>
        <message>
            <source>journal of the simulator, run %1</source>
            <translation>журнал симулятора, запуск %1</translation>
        </message>
        <message>
            <source>keep the tip further out</source>
            <translation>держите остриё дальше от оси</translation>
        </message>
        <message>
            <source>keep the two tips further apart</source>
            <translation>держите острия дальше друг от друга</translation>
        </message>
        <message>
            <source>kernel</source>
            <translation>ядро ОС</translation>
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
            <source>layer %1 lies no higher than the one before</source>
            <translation>слой %1 лежит не выше предыдущего</translation>
        </message>
        <message>
            <source>layer %1 lies no higher than the one before: a table of several passes needs the columns run to clear_mm; export the job again</source>
            <translation>слой %1 не выше предыдущего: таблице нескольких проходов нужны столбцы от run до clear_mm; выгрузите задание заново</translation>
        </message>
        <message>
            <source>layer %1, point %2: a radius of %3 mm, less than core_radius_mm, %4 mm</source>
            <translation>слой %1, точка %2: радиус %3 mm меньше core_radius_mm, %4 mm</translation>
        </message>
        <message>
            <source>layer %1, point %2: axis %3 would have to go to %4 mm, but goes from %5 mm to %6 mm</source>
            <translation>слой %1, точка %2: оси %3 пришлось бы идти до %4 mm, а её ход от %5 mm до %6 mm</translation>
        </message>
        <message>
            <source>layer %1, point %2: psi is not where any joining has it</source>
            <translation>слой %1, точка %2: Ψ не там, где она стоит при каком-либо способе соединения</translation>
        </message>
        <message>
            <source>layer %1, point %2: the height is neither its layer's nor on a spiral's way up</source>
            <translation>слой %1, точка %2: высота не равна высоте слоя и не лежит на подъёме спирали</translation>
        </message>
        <message>
            <source>layer %1, point %2: the radius of %3 is not that in which the layer below ends; slice the model again</source>
            <translation>слой %1, точка %2: радиус %3 не тот, на котором кончается слой ниже; нарежьте модель снова</translation>
        </message>
        <message>
            <source>layer %1, point %2: the radius of %3, %4, is beyond the travel, which ends at %5; make the model smaller</source>
            <translation>слой %1, точка %2: радиус %3, %4, за пределами хода, который кончается на %5; уменьшите модель</translation>
        </message>
        <message>
            <source>layer %1, point %2: the radius of %3, %4, is inside the core radius of %5; carve less deep, or lower core_radius_mm</source>
            <translation>слой %1, точка %2: радиус %3, %4, внутри радиуса сердцевины %5; режьте мельче или уменьшите core_radius_mm</translation>
        </message>
        <message>
            <source>layer %1, point %2: the tips are %3 apart, closer than head_clearance_mm, %4; raise core_radius_mm and slice again</source>
            <translation>слой %1, точка %2: между остриями %3, меньше head_clearance_mm, %4; увеличьте core_radius_mm и нарежьте снова</translation>
        </message>
        <message>
            <source>layer %1: the height of %2 does not lie above the layer below, %3; use fewer layers</source>
            <translation>слой %1: высота %2 не выше слоя ниже, %3; возьмите меньше слоёв</translation>
        </message>
        <message>
            <source>layer %1: the height of %2 is not that of the layer below, %3, as in the ring that closes a spiral; slice the model again</source>
            <translation>слой %1: высота %2 не равна высоте слоя ниже, %3, как в кольце, замыкающем спираль; нарежьте модель снова</translation>
        </message>
        <message>
            <source>layer %1: the height of %2 lies outside the travel of Y, %3 to %4; make the model smaller</source>
            <translation>слой %1: высота %2 вне хода Y, от %3 до %4; уменьшите модель</translation>
        </message>
        <message>
            <source>layers</source>
            <translation>слои</translation>
        </message>
        <message>
            <source>layers %1 to %2</source>
            <translation>слои с %1 по %2</translation>
        </message>
        <message>
            <source>layers %1 to %2, from point %3 on</source>
            <translation>слои с %1 по %2, с точки %3</translation>
        </message>
        <message>
            <source>layers do not count on by one</source>
            <translation>номера слоёв не идут подряд</translation>
        </message>
        <message>
            <source>least blank ⌀ %1 mm</source>
            <translation>наименьшая заготовка ⌀ %1 mm</translation>
        </message>
        <message>
            <source>least lost</source>
            <translation>мин. потеря</translation>
        </message>
        <message>
            <source>leave the parameter as it is: only the machine sets it</source>
            <translation>оставьте параметр как есть: его задаёт только станок</translation>
        </message>
        <message>
            <source>left</source>
            <translation>левая</translation>
        </message>
        <message>
            <source>left out: %1</source>
            <translation>отброшено: %1</translation>
        </message>
        <message>
            <source>let the CAM system compensate: a radial tool has no side</source>
            <translation>поручите коррекцию системе CAM: у радиального инструмента нет стороны</translation>
        </message>
        <message>
            <source>let the CAM system write it out in plain words</source>
            <translation>пусть система CAM выпишет это простыми словами</translation>
        </message>
        <message>
            <source>let the CAM system write the blocks out, or take fewer passes</source>
            <translation>пусть система CAM выпишет кадры, или уменьшите число проходов</translation>
        </message>
        <message>
            <source>let the loop end, or move in it</source>
            <translation>пусть цикл кончается или движет что-то</translation>
        </message>
        <message>
            <source>lies wholly within the core radius of %1 mm: nothing but a plain rod would be carved; it is %2 large: are its units inches? Height makes it larger</source>
            <translation>целиком лежит внутри радиуса сердцевины %1 mm: получился бы только гладкий стержень; размер %2: не в дюймах ли она? Увеличить можно высотой</translation>
        </message>
        <message>
            <source>lies wholly within the core radius of %1 mm: nothing but a plain rod would be carved; it is %2 large: are its units metres? Height makes it larger</source>
            <translation>целиком лежит внутри радиуса сердцевины %1 mm: получился бы только гладкий стержень; размер %2: не в метрах ли она? Увеличить можно высотой</translation>
        </message>
        <message>
            <source>lies wholly within the core radius of %1 mm: nothing but a plain rod would be carved; it is %2 large: make it larger, or core_radius_mm smaller</source>
            <translation>целиком лежит внутри радиуса сердцевины %1 mm: получился бы только гладкий стержень; размер %2: увеличьте модель или уменьшите core_radius_mm</translation>
        </message>
        <message>
            <source>lies wholly within the radius of %1 mm at which the heads' travel ends: nothing but a plain rod would be carved; it is %2 large: are its units inches? Height makes it larger</source>
            <translation>целиком лежит внутри радиуса %1 mm, на котором кончается ход головок: получился бы только гладкий стержень; размер %2: не в дюймах ли она? Увеличить можно высотой</translation>
        </message>
        <message>
            <source>lies wholly within the radius of %1 mm at which the heads' travel ends: nothing but a plain rod would be carved; it is %2 large: are its units metres? Height makes it larger</source>
            <translation>целиком лежит внутри радиуса %1 mm, на котором кончается ход головок: получился бы только гладкий стержень; размер %2: не в метрах ли она? Увеличить можно высотой</translation>
        </message>
        <message>
            <source>lies wholly within the radius of %1 mm at which the heads' travel ends: nothing but a plain rod would be carved; it is %2 large: make it larger, or let travel_mm go further in</source>
            <translation>целиком лежит внутри радиуса %1 mm, на котором кончается ход головок: получился бы только гладкий стержень; размер %2: увеличьте модель или задайте travel_mm дальше внутрь</translation>
        </message>
        <message>
            <source>lift or stay</source>
            <translation>lift или stay</translation>
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
            <source>line %1 has more than 64 MiB: this is no program in G-code</source>
            <translation>в строке %1 больше 64 MiB: это не программа в G-коде</translation>
        </message>
        <message>
            <source>line %1: %2 cannot count so far</source>
            <translation>строка %1: %2 не может отсчитать так далеко</translation>
        </message>
        <message>
            <source>line %1: %2 is not wired to any pin; give its pin in the profile</source>
            <translation>строка %1: %2 не подключён ни к одному контакту; задайте его контакт в профиле</translation>
        </message>
        <message>
            <source>line %1: %2 would come to %3, inside the core radius of %4; carve less deep</source>
            <translation>строка %1: %2 пришла бы в %3, внутрь радиуса сердцевины %4; режьте мельче</translation>
        </message>
        <message>
            <source>line %1: %2 would come to %3, its travel is %4 to %5; move the work offset</source>
            <translation>строка %1: %2 пришла бы в %3, её ход от %4 до %5; сдвиньте смещение детали</translation>
        </message>
        <message>
            <source>line %1: it is not known where %2 begins</source>
            <translation>строка %1: неизвестно, откуда начинает %2</translation>
        </message>
        <message>
            <source>line %1: it would take more than %2 ms; change its feed or its dwell</source>
            <translation>строка %1: это заняло бы больше %2 мс; измените подачу или выдержку</translation>
        </message>
        <message>
            <source>line %1: its ends are not as far from the arc's centre as each other; start it again</source>
            <translation>строка %1: концы дуги не одинаково удалены от её центра; запустите заново</translation>
        </message>
        <message>
            <source>line %1: the core does not know what this line asks for; is it another version?</source>
            <translation>строка %1: ядро не знает, чего требует эта строка; не другая ли это версия?</translation>
        </message>
        <message>
            <source>line %1: the program does not reach the core as it was read; start it again</source>
            <translation>строка %1: программа доходит до ядра не такой, какой прочитана; запустите её снова</translation>
        </message>
        <message>
            <source>line %1: the program goes on after its end</source>
            <translation>строка %1: программа продолжается после своего конца</translation>
        </message>
        <message>
            <source>line %1: the tips would be %2 apart, closer than head_clearance_mm, %3; carve less deep</source>
            <translation>строка %1: между остриями было бы %2, меньше head_clearance_mm, %3; режьте мельче</translation>
        </message>
        <message>
            <source>line %1: the tips, %2 apart at one end, would pass each other closer than head_clearance_mm, %3; move one head after the other</source>
            <translation>строка %1: острия, между которыми на одном конце %2, прошли бы ближе head_clearance_mm, %3; двигайте головки по очереди</translation>
        </message>
        <message>
            <source>line %1: the tolerance %2 is not between 0 and %3; change the P of G64</source>
            <translation>строка %1: допуск %2 не лежит между 0 и %3; измените P в G64</translation>
        </message>
        <message>
            <source>linear</source>
            <translation>лин.</translation>
        </message>
        <message>
            <source>lines are engraved once they are sliced</source>
            <translation>линии гравируются после нарезки</translation>
        </message>
        <message>
            <source>loaded</source>
            <translation>загружен</translation>
        </message>
        <message>
            <source>locked</source>
            <translation>заперто</translation>
        </message>
        <message>
            <source>locked memory</source>
            <translation>закреплённая память</translation>
        </message>
        <message>
            <source>lookahead or angle</source>
            <translation>lookahead или angle</translation>
        </message>
        <message>
            <source>looking for the best axis was cancelled</source>
            <translation>поиск лучшей оси отменён</translation>
        </message>
        <message>
            <source>loops and calls make more than %1 blocks</source>
            <translation>циклы и вызовы дают больше %1 кадров</translation>
        </message>
        <message>
            <source>loops and subroutines of a stream have more than 64 MiB</source>
            <translation>циклы и подпрограммы потока занимают больше 64 MiB</translation>
        </message>
        <message>
            <source>low</source>
            <translation>низкий</translation>
        </message>
        <message>
            <source>machine or turning</source>
            <translation>machine или turning</translation>
        </message>
        <message>
            <source>marks %1 mm apart in height; more than %2 mm is no error of mounting. Was Y left alone?</source>
            <translation>метки по высоте в %1 mm друг от друга; больше %2 mm — не погрешность монтажа. Y не трогали?</translation>
        </message>
        <message>
            <source>marks %1 mm apart on a blank of %2 mm would be %3°; more than %4° is no error of mounting. Was the table turned by exactly half a turn?</source>
            <translation>метки в %1 mm друг от друга на заготовке %2 mm — это %3°; больше %4° — не погрешность монтажа. Стол повёрнут ровно на пол-оборота?</translation>
        </message>
        <message>
            <source>may not be read by this user; let the machine's group read it, or name another folder: $PSICARVE_STATE</source>
            <translation>этот пользователь не может его прочитать; разрешите чтение группе станка или укажите другую папку: $PSICARVE_STATE</translation>
        </message>
        <message>
            <source>may not be written</source>
            <translation>нельзя писать</translation>
        </message>
        <message>
            <source>memory locked</source>
            <translation>память закреплена</translation>
        </message>
        <message>
            <source>memory touched</source>
            <translation>память занята заранее</translation>
        </message>
        <message>
            <source>min, max or none</source>
            <translation>min, max или none</translation>
        </message>
        <message>
            <source>missed %1</source>
            <translation>пропущено %1</translation>
        </message>
        <message>
            <source>missed %1 of %2 a second</source>
            <translation>пропущено %1 из %2 в секунду</translation>
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
            <source>mm for each unit of the file</source>
            <translation>mm на единицу файла</translation>
        </message>
        <message>
            <source>model</source>
            <translation>модель</translation>
        </message>
        <message>
            <source>modprobe ppdev</source>
            <translation>modprobe ppdev</translation>
        </message>
        <message>
            <source>module lp</source>
            <translation>модуль lp</translation>
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
            <source>more points than pulses: %1 points in half a turn of %2 pulses</source>
            <translation>точек больше, чем импульсов: %1 точек на полоборота из %2 импульсов</translation>
        </message>
        <message>
            <source>more than %1 points when its curves are cut into straight pieces; nobody can carve that</source>
            <translation>более %1 точек после разбиения кривых на отрезки; такое не вырезать</translation>
        </message>
        <message>
            <source>more than %1 runs, which no job has</source>
            <translation>больше %1 участков, столько нет ни в одном задании</translation>
        </message>
        <message>
            <source>more than 10000 named parameters</source>
            <translation>больше 10000 параметров с именами</translation>
        </message>
        <message>
            <source>more than 10000 subroutines</source>
            <translation>больше 10000 подпрограмм</translation>
        </message>
        <message>
            <source>more than 1000000000 passes</source>
            <translation>больше 1000000000 повторений</translation>
        </message>
        <message>
            <source>more than 512 MiB, which no drawing or picture needs</source>
            <translation>более 512 MiB: чертежу или изображению столько не нужно</translation>
        </message>
        <message>
            <source>more than a gigabyte, which no table needs</source>
            <translation>более гигабайта: таблице столько не нужно</translation>
        </message>
        <message>
            <source>more than four million values in one element</source>
            <translation>более четырёх миллионов значений в одном элементе</translation>
        </message>
        <message>
            <source>mount -o remount,size=1G /dev/shm, or psicarve-rtcore --capacity for smaller jobs</source>
            <translation>mount -o remount,size=1G /dev/shm или psicarve-rtcore --capacity для меньших заданий</translation>
        </message>
        <message>
            <source>mount a tmpfs there</source>
            <translation>смонтируйте там tmpfs</translation>
        </message>
        <message>
            <source>move</source>
            <translation>перемещение</translation>
        </message>
        <message>
            <source>move the work offset, or the part</source>
            <translation>сдвиньте смещение детали или деталь</translation>
        </message>
        <message>
            <source>moving</source>
            <translation>движется</translation>
        </message>
        <message>
            <source>no arc, %1 and Y differ in pulses_per_mm</source>
            <translation>дуги нет: у %1 и Y разные pulses_per_mm</translation>
        </message>
        <message>
            <source>no axis goes so far (%1)</source>
            <translation>так далеко ни одна ось не ходит (%1)</translation>
        </message>
        <message>
            <source>no axis to move</source>
            <translation>нет оси, которую нужно переместить</translation>
        </message>
        <message>
            <source>no blank has %1 mm; %2 to %3 mm can be</source>
            <translation>заготовки в %1 mm не бывает; возможно от %2 до %3 mm</translation>
        </message>
        <message>
            <source>no core</source>
            <translation>нет ядра</translation>
        </message>
        <message>
            <source>no core has it; one that is started says whether a port is there</source>
            <translation>не занят никаким ядром; есть ли там порт, скажет ядро при запуске</translation>
        </message>
        <message>
            <source>no core serves segment %1</source>
            <translation>сегмент %1 не обслуживает ни одно ядро</translation>
        </message>
        <message>
            <source>no function begins so</source>
            <translation>ни одна функция так не начинается</translation>
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
            <source>no layer was finished</source>
            <translation>ни один слой не закончен</translation>
        </message>
        <message>
            <source>no layer was finished; start from the beginning, or with layer %1 for the piece of before</source>
            <translation>ни один слой не закончен; начните сначала, а для прежней детали — со слоя %1</translation>
        </message>
        <message>
            <source>no lines to engrave</source>
            <translation>нет линий для гравировки</translation>
        </message>
        <message>
            <source>no longer in the machine</source>
            <translation>уже не в станке</translation>
        </message>
        <message>
            <source>no motion is in force that uses axis words</source>
            <translation>не действует движение, использующее слова осей</translation>
        </message>
        <message>
            <source>no parameter has this number</source>
            <translation>параметра с таким номером нет</translation>
        </message>
        <message>
            <source>no pin</source>
            <translation>нет вывода</translation>
        </message>
        <message>
            <source>no pin has %1 mm; %2 to %3 mm can be</source>
            <translation>штифта в %1 mm не бывает; возможно от %2 до %3 mm</translation>
        </message>
        <message>
            <source>no program runs</source>
            <translation>программа не выполняется</translation>
        </message>
        <message>
            <source>no radius is beyond that of %1 mm at which the heads' travel ends: nothing but a plain rod would be carved; larger radii, or a travel_mm that goes further in, carve more</source>
            <translation>ни один радиус не больше %1 mm, на котором кончается ход головок: получился бы только гладкий стержень; нужны большие радиусы или travel_mm дальше внутрь</translation>
        </message>
        <message>
            <source>no right to addresses</source>
            <translation>нет права на адреса портов</translation>
        </message>
        <message>
            <source>no right to addresses; --port ppdev:/dev/parport0 needs no such right</source>
            <translation>нет права на адреса портов; для --port ppdev:/dev/parport0 такое право не нужно</translation>
        </message>
        <message>
            <source>no roughing passes: nothing of the blank stands further out than the allowance</source>
            <translation>черновых проходов нет: ничто от заготовки не выступает за припуск</translation>
        </message>
        <message>
            <source>no such axis</source>
            <translation>такой оси нет</translation>
        </message>
        <message>
            <source>no such file</source>
            <translation>нет такого файла</translation>
        </message>
        <message>
            <source>no such output</source>
            <translation>такого выхода нет</translation>
        </message>
        <message>
            <source>no virtual machine</source>
            <translation>не виртуальная машина</translation>
        </message>
        <message>
            <source>no. %1</source>
            <translation>№ %1</translation>
        </message>
        <message>
            <source>no. %1, %2 % done</source>
            <translation>№ %1, готово %2 %</translation>
        </message>
        <message>
            <source>no. %1, dry run %2 %</source>
            <translation>№ %1, прогон %2 %</translation>
        </message>
        <message>
            <source>no: a dry run carves nothing</source>
            <translation>нет: холостой прогон ничего не режет</translation>
        </message>
        <message>
            <source>no: its pins were not recorded (page Ports)</source>
            <translation>нет: выводы не записаны (страница «Порты»)</translation>
        </message>
        <message>
            <source>nobody holds its lease</source>
            <translation>никто не удерживает движение</translation>
        </message>
        <message>
            <source>nobody knows how far it was carved; look at the piece and choose the layer</source>
            <translation>неизвестно, докуда вырезано; осмотрите заготовку и выберите слой</translation>
        </message>
        <message>
            <source>none</source>
            <translation>нет</translation>
        </message>
        <message>
            <source>none is kept free</source>
            <translation>ни один не оставлен свободным</translation>
        </message>
        <message>
            <source>none: add it</source>
            <translation>нет: добавьте</translation>
        </message>
        <message>
            <source>none: not %1</source>
            <translation>нет: не %1</translation>
        </message>
        <message>
            <source>none: ticks may be late</source>
            <translation>нет: такты могут запаздывать</translation>
        </message>
        <message>
            <source>not</source>
            <translation>нет</translation>
        </message>
        <message>
            <source>not a picture that can be read here (PNG, JPEG, TIFF, BMP, PGM)</source>
            <translation>не изображение, которое здесь читается (PNG, JPEG, TIFF, BMP, PGM)</translation>
        </message>
        <message>
            <source>not allowed</source>
            <translation>не разрешено</translation>
        </message>
        <message>
            <source>not asked for</source>
            <translation>не запрошено</translation>
        </message>
        <message>
            <source>not changed by the kernel</source>
            <translation>ядро ОС не меняет</translation>
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
            <source>not known: the surface is not closed, or turned both ways</source>
            <translation>неизвестен: поверхность не замкнута или повёрнута по-разному</translation>
        </message>
        <message>
            <source>not needed</source>
            <translation>не нужны</translation>
        </message>
        <message>
            <source>not needed on the virtual clock</source>
            <translation>при виртуальных часах не нужны</translation>
        </message>
        <message>
            <source>not published</source>
            <translation>не передано</translation>
        </message>
        <message>
            <source>not reached</source>
            <translation>не достигнута</translation>
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
            <source>nothing</source>
            <translation>ничего</translation>
        </message>
        <message>
            <source>nothing in the block uses %1</source>
            <translation>в кадре ничто не использует %1</translation>
        </message>
        <message>
            <source>nothing is open</source>
            <translation>ничего не открыто</translation>
        </message>
        <message>
            <source>nothing that can be read here: a mesh (STL, OBJ, PLY, 3MF, OFF), a drawing (SVG, DXF), a picture (PNG, JPEG, TIFF, BMP, PGM) or a table (CSV)</source>
            <translation>ничего, что здесь читается: сетки (STL, OBJ, PLY, 3MF, OFF), чертежа (SVG, DXF), изображения (PNG, JPEG, TIFF, BMP, PGM) или таблицы (CSV)</translation>
        </message>
        <message>
            <source>nothing was carved</source>
            <translation>ничего не вырезано</translation>
        </message>
        <message>
            <source>nothing was carved yet</source>
            <translation>ещё ничего не вырезано</translation>
        </message>
        <message>
            <source>o%1 is a subroutine in line %2</source>
            <translation>o%1 — подпрограмма в строке %2</translation>
        </message>
        <message>
            <source>o%1 sub is called by o%1 call</source>
            <translation>o%1 sub вызывается через o%1 call</translation>
        </message>
        <message>
            <source>of %1</source>
            <translation>из %1</translation>
        </message>
        <message>
            <source>of an unknown text</source>
            <translation>текст неизвестен</translation>
        </message>
        <message>
            <source>off</source>
            <translation>выключен</translation>
        </message>
        <message>
            <source>on hold; Resume goes on</source>
            <translation>на паузе; «Продолжить» ведёт дальше</translation>
        </message>
        <message>
            <source>only --port io:ADDRESS can drive a machine</source>
            <translation>станком можно управлять только через --port io:ADDRESS</translation>
        </message>
        <message>
            <source>only in a trace</source>
            <translation>только в трассе</translation>
        </message>
        <message>
            <source>only the simulated machine can be driven</source>
            <translation>управлять можно только симулированным станком</translation>
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
            <source>open edges</source>
            <translation>открытые рёбра</translation>
        </message>
        <message>
            <source>open edges: %1</source>
            <translation>открытых рёбер: %1</translation>
        </message>
        <message>
            <source>opening was cancelled</source>
            <translation>открытие отменено</translation>
        </message>
        <message>
            <source>optional stop (M1)</source>
            <translation>условный останов (M1)</translation>
        </message>
        <message>
            <source>optional-stop</source>
            <translation>останов по выбору</translation>
        </message>
        <message>
            <source>ordinary scheduling</source>
            <translation>обычное планирование</translation>
        </message>
        <message>
            <source>other</source>
            <translation>прочее</translation>
        </message>
        <message>
            <source>other programs and interrupts run where the tick does</source>
            <translation>другие программы и прерывания работают там же, где такт</translation>
        </message>
        <message>
            <source>out</source>
            <translation>выход</translation>
        </message>
        <message>
            <source>outputs and inputs have numbers 0 to 63</source>
            <translation>номера выходов и входов — от 0 до 63</translation>
        </message>
        <message>
            <source>over-ticks or within-tick</source>
            <translation>over-ticks или within-tick</translation>
        </message>
        <message>
            <source>override</source>
            <translation>коррекция</translation>
        </message>
        <message>
            <source>override of rapids</source>
            <translation>коррекция быстрых перемещений</translation>
        </message>
        <message>
            <source>own or follow</source>
            <translation>own или follow</translation>
        </message>
        <message>
            <source>parallel port</source>
            <translation>параллельный порт</translation>
        </message>
        <message>
            <source>pass 30 values at most</source>
            <translation>передавайте не больше 30 значений</translation>
        </message>
        <message>
            <source>passed</source>
            <translation>пройдено</translation>
        </message>
        <message>
            <source>path or stepwise</source>
            <translation>path или stepwise</translation>
        </message>
        <message>
            <source>performance</source>
            <translation>производительность</translation>
        </message>
        <message>
            <source>pins</source>
            <translation>проверка контакта</translation>
        </message>
        <message>
            <source>plan starved</source>
            <translation>расчёт не успел</translation>
        </message>
        <message>
            <source>point by point takes one or two of R1, R2 and Y</source>
            <translation>по точкам движутся одна или две из осей R1, R2 и Y</translation>
        </message>
        <message>
            <source>point, ball, flat or vee</source>
            <translation>point, ball, flat или vee</translation>
        </message>
        <message>
            <source>points</source>
            <translation>точки</translation>
        </message>
        <message>
            <source>points do not follow each other from 0 on, as many in each layer</source>
            <translation>точки должны идти подряд от 0, поровну в каждом слое</translation>
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
            <source>priority up to %1</source>
            <translation>приоритет до %1</translation>
        </message>
        <message>
            <source>priority up to %1 only, the tick has %2</source>
            <translation>приоритет только до %1, у такта %2</translation>
        </message>
        <message>
            <source>processor %1</source>
            <translation>процессор %1</translation>
        </message>
        <message>
            <source>processor of the tick</source>
            <translation>процессор такта</translation>
        </message>
        <message>
            <source>processor sleep</source>
            <translation>сон процессора</translation>
        </message>
        <message>
            <source>processor speed</source>
            <translation>частота процессора</translation>
        </message>
        <message>
            <source>processor: as the core</source>
            <translation>процессор: как у ядра</translation>
        </message>
        <message>
            <source>processors kept awake</source>
            <translation>процессоры не засыпают</translation>
        </message>
        <message>
            <source>processors that sleep deeply wake up late</source>
            <translation>глубоко спящий процессор просыпается поздно</translation>
        </message>
        <message>
            <source>profile</source>
            <translation>профиль</translation>
        </message>
        <message>
            <source>profile %1</source>
            <translation>профиль %1</translation>
        </message>
        <message>
            <source>profile as the job's</source>
            <translation>профиль как у задания</translation>
        </message>
        <message>
            <source>profile unknown</source>
            <translation>профиль неизвестен</translation>
        </message>
        <message>
            <source>profile: %1</source>
            <translation>профиль: %1</translation>
        </message>
        <message>
            <source>program</source>
            <translation>программа</translation>
        </message>
        <message>
            <source>program %1 is not the one that waits to be run; start it again</source>
            <translation>программа %1 — не та, что ждёт запуска; запустите её снова</translation>
        </message>
        <message>
            <source>psi goes further in a layer than any machine</source>
            <translation>Ψ проходит за слой больше, чем может любой станок</translation>
        </message>
        <message>
            <source>psicarve gcode run FILE --from-line %1</source>
            <translation>psicarve gcode run FILE --from-line %1</translation>
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
            <source>pulses and counts are whole numbers</source>
            <translation>импульсы и счётчики — целые числа</translation>
        </message>
        <message>
            <source>put % on a line of its own, as the first and the last one</source>
            <translation>ставьте % в отдельную строку, первую и последнюю</translation>
        </message>
        <message>
            <source>put it where docs/gcode.md allows it</source>
            <translation>поставьте его туда, где допускает docs/gcode.md</translation>
        </message>
        <message>
            <source>put one of the two into a block of its own</source>
            <translation>перенесите одно из двух в отдельный кадр</translation>
        </message>
        <message>
            <source>put the units into a block before the feed</source>
            <translation>задайте единицы в кадре перед подачей</translation>
        </message>
        <message>
            <source>queue: %1 of %2</source>
            <translation>очередь: %1 из %2</translation>
        </message>
        <message>
            <source>radii</source>
            <translation>радиусы</translation>
        </message>
        <message>
            <source>radii of R1: %1 points differ, the first in layer %2, point %3, counted from 0</source>
            <translation>радиусы R1: отличаются точек %1, первая в слое %2, точка %3, счёт с 0</translation>
        </message>
        <message>
            <source>radii of R2: %1 points differ, the first in layer %2, point %3, counted from 0</source>
            <translation>радиусы R2: отличаются точек %1, первая в слое %2, точка %3, счёт с 0</translation>
        </message>
        <message>
            <source>raise the limit: a line "@GROUP - memlock unlimited" in /etc/security/limits.d and a new login, or the capability CAP_IPC_LOCK</source>
            <translation>поднимите предел: строка "@GROUP - memlock unlimited" в /etc/security/limits.d и новый вход, или право CAP_IPC_LOCK</translation>
        </message>
        <message>
            <source>raw addresses</source>
            <translation>прямые адреса портов</translation>
        </message>
        <message>
            <source>reachable</source>
            <translation>достижимо</translation>
        </message>
        <message>
            <source>reading it takes about a microsecond, several times a tick</source>
            <translation>чтение занимает около микросекунды, несколько раз за такт</translation>
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
            <source>real-time scheduling</source>
            <translation>планирование реального времени</translation>
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
            <source>refused</source>
            <translation>отказано</translation>
        </message>
        <message>
            <source>replay --program FILE</source>
            <translation>replay --program FILE</translation>
        </message>
        <message>
            <source>report of the slicer</source>
            <translation>отчёт нарезки</translation>
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
            <source>return outside a subroutine</source>
            <translation>return вне подпрограммы</translation>
        </message>
        <message>
            <source>right</source>
            <translation>правая</translation>
        </message>
        <message>
            <source>rmmod lp, and keep it out: a line "blacklist lp" in /etc/modprobe.d</source>
            <translation>rmmod lp, и чтобы не вернулся: строка "blacklist lp" в /etc/modprobe.d</translation>
        </message>
        <message>
            <source>roughing %1 of %2</source>
            <translation>черновой %1 из %2</translation>
        </message>
        <message>
            <source>roughing begins at the blank's surface: say how large the blank is, or choose finishing only</source>
            <translation>черновая обработка начинается с поверхности заготовки: укажите её размер или выберите «только чистовая»</translation>
        </message>
        <message>
            <source>roughing needs level layers, which a table of a spiral does not have: slice the model with roughing, or choose finishing only</source>
            <translation>черновой обработке нужны ровные слои, которых в таблице спирали нет: нарежьте модель с черновой обработкой или выберите «только чистовая»</translation>
        </message>
        <message>
            <source>run with CAP_SYS_RAWIO, or use --port ppdev:/dev/parport0</source>
            <translation>запустите с CAP_SYS_RAWIO или используйте --port ppdev:/dev/parport0</translation>
        </message>
        <message>
            <source>runs and passes do not count on by one</source>
            <translation>run и pass не растут по одному</translation>
        </message>
        <message>
            <source>say with P how near corners are passed</source>
            <translation>задайте через P, насколько близко проходить углы</translation>
        </message>
        <message>
            <source>say with an axis word what is to be done</source>
            <translation>скажите словом оси, что делать</translation>
        </message>
        <message>
            <source>says nothing here</source>
            <translation>здесь ничего не значит</translation>
        </message>
        <message>
            <source>see in the kernel's messages why the tsc is not trusted; often the firmware is to blame</source>
            <translation>посмотрите в сообщениях ядра ОС, почему tsc не доверяют; часто виновата прошивка</translation>
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
            <source>set R above the depth of the hole</source>
            <translation>задайте R выше дна отверстия</translation>
        </message>
        <message>
            <source>set the centre off the arc</source>
            <translation>задайте центр вне концов дуги</translation>
        </message>
        <message>
            <source>set the parameter before it is used</source>
            <translation>задайте параметр до использования</translation>
        </message>
        <message>
            <source>set the speed at the spindle</source>
            <translation>задайте скорость на самом шпинделе</translation>
        </message>
        <message>
            <source>shared memory</source>
            <translation>разделяемая память</translation>
        </message>
        <message>
            <source>shortest or written</source>
            <translation>shortest или written</translation>
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
            <source>single</source>
            <translation>покадрово</translation>
        </message>
        <message>
            <source>single block</source>
            <translation>по кадрам</translation>
        </message>
        <message>
            <source>single block: this one is done; Resume runs the next</source>
            <translation>покадрово: этот кадр выполнен; «Продолжить» исполняет следующий</translation>
        </message>
        <message>
            <source>single or two-timer</source>
            <translation>single или two-timer</translation>
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
            <source>something stands behind the O word</source>
            <translation>после слова O что-то стоит</translation>
        </message>
        <message>
            <source>spindle</source>
            <translation>шпиндель</translation>
        </message>
        <message>
            <source>spiral</source>
            <translation>спираль</translation>
        </message>
        <message>
            <source>split the block: a line has 1024 bytes at most</source>
            <translation>разделите кадр: в строке не больше 1024 байт</translation>
        </message>
        <message>
            <source>stands %1 mm above the table, and the blank is only %2 mm high: nothing of it is left to be carved</source>
            <translation>стоит на %1 mm выше стола, а заготовка высотой лишь %2 mm: вырезать нечего</translation>
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
            <source>start the core with --clock virtual, or raise tick.missed_alarm_per_s</source>
            <translation>запустите ядро с --clock virtual или увеличьте tick.missed_alarm_per_s</translation>
        </message>
        <message>
            <source>start the kernel with isolcpus=N nohz_full=N rcu_nocbs=N, N the last processor</source>
            <translation>запустите ядро ОС с isolcpus=N nohz_full=N rcu_nocbs=N, N — последний процессор</translation>
        </message>
        <message>
            <source>start the kernel with processor.max_cstate=1, or one that has that device</source>
            <translation>запустите ядро ОС с processor.max_cstate=1 или ядро с этим устройством</translation>
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
            <source>status</source>
            <translation>состояние</translation>
        </message>
        <message>
            <source>status: %1</source>
            <translation>состояние: %1</translation>
        </message>
        <message>
            <source>step by step</source>
            <translation>по шагам</translation>
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
            <source>stop (M0)</source>
            <translation>останов (M0)</translation>
        </message>
        <message>
            <source>stopped</source>
            <translation>остановлено</translation>
        </message>
        <message>
            <source>stopped %1</source>
            <translation>остановлено в %1</translation>
        </message>
        <message>
            <source>stopped by the operator</source>
            <translation>остановлена оператором</translation>
        </message>
        <message>
            <source>stopped in layer %1</source>
            <translation>остановлено в слое %1</translation>
        </message>
        <message>
            <source>stopping</source>
            <translation>останавливается</translation>
        </message>
        <message>
            <source>store the program in a file: there it may be of any length</source>
            <translation>сохраните программу в файл: там она может быть любой длины</translation>
        </message>
        <message>
            <source>straight line</source>
            <translation>прямая</translation>
        </message>
        <message>
            <source>supervisor stalled</source>
            <translation>ядро не слышало команд</translation>
        </message>
        <message>
            <source>swap</source>
            <translation>подкачка</translation>
        </message>
        <message>
            <source>swapoff --all while carving, or more memory</source>
            <translation>swapoff --all во время резьбы или больше памяти</translation>
        </message>
        <message>
            <source>switch coolant by hand</source>
            <translation>включайте охлаждение вручную</translation>
        </message>
        <message>
            <source>systems have numbers 0 to 9</source>
            <translation>номера систем — от 0 до 9</translation>
        </message>
        <message>
            <source>take it out: nothing is wired there</source>
            <translation>уберите: там ничего не подключено</translation>
        </message>
        <message>
            <source>take it out: the operator's overrides always hold</source>
            <translation>уберите: коррекция оператора действует всегда</translation>
        </message>
        <message>
            <source>take the inner ( away</source>
            <translation>уберите внутреннюю (</translation>
        </message>
        <message>
            <source>take the word away, or add the code that it is for</source>
            <translation>уберите слово или добавьте код, для которого оно</translation>
        </message>
        <message>
            <source>taken up to line %1</source>
            <translation>принято до строки %1</translation>
        </message>
        <message>
            <source>takes %1, with those before %2</source>
            <translation>%1, с предыдущими %2</translation>
        </message>
        <message>
            <source>takes about %1, with those before %2</source>
            <translation>занимает около %1, вместе с предыдущими %2</translation>
        </message>
        <message>
            <source>takes at least %1, with those before %2</source>
            <translation>не менее %1, с предыдущими %2</translation>
        </message>
        <message>
            <source>testing</source>
            <translation>проверка</translation>
        </message>
        <message>
            <source>that is a record of the other kind of machine; this core keeps none</source>
            <translation>это запись другого вида станка; у этого ядра таких нет</translation>
        </message>
        <message>
            <source>the XML ends too early</source>
            <translation>XML обрывается</translation>
        </message>
        <message>
            <source>the allowance must be 0 to %1, not %2</source>
            <translation>припуск должен быть от 0 до %1, а не %2</translation>
        </message>
        <message>
            <source>the arc ends where it begins</source>
            <translation>дуга кончается там, где начинается</translation>
        </message>
        <message>
            <source>the arc has a centre and a radius</source>
            <translation>у дуги и центр, и радиус</translation>
        </message>
        <message>
            <source>the arc has no centre and no radius</source>
            <translation>у дуги нет ни центра, ни радиуса</translation>
        </message>
        <message>
            <source>the arc's centre lies on one of its ends</source>
            <translation>центр дуги лежит на одном из её концов</translation>
        </message>
        <message>
            <source>the arc's radius is %1 mm at its begin and %2 mm at its end</source>
            <translation>радиус дуги в начале %1 mm, а в конце %2 mm</translation>
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
            <source>the axis passes beside the model and no sample meets it: nothing but the core would be carved; choose another axis</source>
            <translation>ось проходит мимо модели, и ни один отсчёт её не встречает: вырезан был бы один сердечник; выберите другую ось</translation>
        </message>
        <message>
            <source>the blank reaches out to %1, but head %2 only to %3: it would stand in the blank before the carving begins; take a smaller blank</source>
            <translation>заготовка доходит до %1, а головка %2 только до %3: она стояла бы в заготовке ещё до начала; возьмите заготовку меньше</translation>
        </message>
        <message>
            <source>the built-in profile has no file: save it under a name</source>
            <translation>у встроенного профиля нет файла: сохраните его под именем</translation>
        </message>
        <message>
            <source>the centre: no axis goes so far (%1)</source>
            <translation>центр: так далеко ни одна ось не ходит (%1)</translation>
        </message>
        <message>
            <source>the comment has no end</source>
            <translation>у комментария нет конца</translation>
        </message>
        <message>
            <source>the computer has too little free memory: end other programs</source>
            <translation>мало свободной памяти: завершите другие программы</translation>
        </message>
        <message>
            <source>the core cannot drive it</source>
            <translation>ядро не может им управлять</translation>
        </message>
        <message>
            <source>the core cannot record so, or knows nobody to record for</source>
            <translation>ядро так не записывает или не знает, для кого записывать</translation>
        </message>
        <message>
            <source>the core did not answer within %1 ms</source>
            <translation>ядро не ответило за %1 ms</translation>
        </message>
        <message>
            <source>the core did not judge the job within %1 ms</source>
            <translation>ядро не проверило задание за %1 мс</translation>
        </message>
        <message>
            <source>the core did not take the program's next step in time</source>
            <translation>ядро не приняло вовремя следующий шаг программы</translation>
        </message>
        <message>
            <source>the core does not know this command; is it another version?</source>
            <translation>ядро не знает этой команды; не другая ли это версия?</translation>
        </message>
        <message>
            <source>the core ended before it answered</source>
            <translation>ядро завершилось, не ответив</translation>
        </message>
        <message>
            <source>the core has another profile than %1; open the one that it was started with</source>
            <translation>у ядра другой профиль, чем %1; откройте тот, с которым оно запущено</translation>
        </message>
        <message>
            <source>the core has refused the next line: only Stop is left</source>
            <translation>ядро отклонило следующую строку: остаётся только «Стоп»</translation>
        </message>
        <message>
            <source>the core of segment %1 (process %2) is silent</source>
            <translation>ядро сегмента %1 (процесс %2) молчит</translation>
        </message>
        <message>
            <source>the core refuses it and gives no reason</source>
            <translation>ядро отказало, не назвав причины</translation>
        </message>
        <message>
            <source>the core runs with another profile than %1; start it with that one</source>
            <translation>ядро работает с другим профилем, не с %1; запустите его с этим</translation>
        </message>
        <message>
            <source>the core takes no more of this program; start it again</source>
            <translation>ядро больше не принимает эту программу; запустите её снова</translation>
        </message>
        <message>
            <source>the core was replaced before it did this</source>
            <translation>ядро заменили, прежде чем оно это сделало</translation>
        </message>
        <message>
            <source>the core's disk has another record of this piece; look again</source>
            <translation>на диске ядра другая запись об этой детали; посмотрите ещё раз</translation>
        </message>
        <message>
            <source>the core's memory is locked, but a computer that swaps is late with everything else</source>
            <translation>память ядра закреплена, но компьютер с подкачкой опаздывает во всём остальном</translation>
        </message>
        <message>
            <source>the diameter of the blank is needed</source>
            <translation>нужен диаметр заготовки</translation>
        </message>
        <message>
            <source>the diameter of the pin is needed</source>
            <translation>нужен диаметр штифта</translation>
        </message>
        <message>
            <source>the disk does not answer, and too much waits for it</source>
            <translation>диск не отвечает, и слишком многое его ждёт</translation>
        </message>
        <message>
            <source>the drawing is %1 mm high, and the cylinder only %2 mm: choose a larger height or a smaller scale</source>
            <translation>высота чертежа %1 mm, а цилиндра всего %2 mm: выберите большую высоту или меньший масштаб</translation>
        </message>
        <message>
            <source>the drawing is %1 mm wide, and once round the cylinder are only %2 mm: choose a scale of at most %3, a larger diameter, or all round</source>
            <translation>ширина чертежа %1 mm, а окружность цилиндра всего %2 mm: выберите масштаб не более %3, больший диаметр или по кругу</translation>
        </message>
        <message>
            <source>the drawing would be more than ten metres wide or high</source>
            <translation>чертёж был бы больше десяти метров в ширину или высоту</translation>
        </message>
        <message>
            <source>the drawing's width or height is not more than 0</source>
            <translation>ширина или высота чертежа не больше 0</translation>
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
            <source>the file ends too early: there is no EOF</source>
            <translation>файл обрывается: нет EOF</translation>
        </message>
        <message>
            <source>the file is empty</source>
            <translation>файл пуст</translation>
        </message>
        <message>
            <source>the finishing pass is missing: the last run is of a roughing pass, and leaves what the model does not have</source>
            <translation>нет чистового прохода: последний участок принадлежит черновому проходу и оставляет то, чего нет в модели</translation>
        </message>
        <message>
            <source>the first element is not &lt;svg&gt;</source>
            <translation>первый элемент не &lt;svg&gt;</translation>
        </message>
        <message>
            <source>the guard process ended; start the core again</source>
            <translation>сторожевой процесс завершился; запустите ядро снова</translation>
        </message>
        <message>
            <source>the job from its begin</source>
            <translation>задание с начала</translation>
        </message>
        <message>
            <source>the job has no such layer</source>
            <translation>в задании нет такого слоя</translation>
        </message>
        <message>
            <source>the job has not so many layers, but %1</source>
            <translation>в задании нет столько слоёв, их %1</translation>
        </message>
        <message>
            <source>the job is carved to its end</source>
            <translation>задание вырезано до конца</translation>
        </message>
        <message>
            <source>the job is published, but no core serves segment %1</source>
            <translation>задание опубликовано, но сегмент %1 не обслуживает ни одно ядро</translation>
        </message>
        <message>
            <source>the job is unsound: %1</source>
            <translation>задание неисправно: %1</translation>
        </message>
        <message>
            <source>the job that it carries is damaged</source>
            <translation>записанное в нём задание повреждено</translation>
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
            <source>the job's blank has a height of %1, the profile's %2, which is in the heads' way</source>
            <translation>высота заготовки задания %1, в профиле %2: она окажется на пути головок</translation>
        </message>
        <message>
            <source>the job's blank has a height of %1, the profile's %2: a part of the job is air</source>
            <translation>высота заготовки задания %1, в профиле %2: часть задания пройдёт по воздуху</translation>
        </message>
        <message>
            <source>the job's blank has a radius of %1, the profile's %2, which is in the heads' way</source>
            <translation>радиус заготовки задания %1, в профиле %2: она окажется на пути головок</translation>
        </message>
        <message>
            <source>the job's blank has a radius of %1, the profile's %2: a part of the job is air</source>
            <translation>радиус заготовки задания %1, в профиле %2: часть задания пройдёт по воздуху</translation>
        </message>
        <message>
            <source>the job's blank stands %1 beside the profile's, which is in the heads' way</source>
            <translation>заготовка задания стоит в стороне от указанной в профиле на %1, и та окажется на пути головок</translation>
        </message>
        <message>
            <source>the job's blank stands %1 beside the profile's: a part of the job is air</source>
            <translation>заготовка задания стоит в стороне от указанной в профиле на %1: часть задания пройдёт по воздуху</translation>
        </message>
        <message>
            <source>the job's direction of axis %1 is the other way round on this machine; slice the model for this machine's profile</source>
            <translation>направление оси %1 в задании на этом станке обратное; нарежьте модель для профиля этого станка</translation>
        </message>
        <message>
            <source>the kernel has one, but /dev/parport0 is not there</source>
            <translation>у ядра ОС он есть, но /dev/parport0 нет</translation>
        </message>
        <message>
            <source>the kernel itself keeps the tick waiting, at times for milliseconds; they are skipped and counted</source>
            <translation>ядро ОС само задерживает такт, иногда на миллисекунды; такие такты пропускаются и считаются</translation>
        </message>
        <message>
            <source>the largest job takes %1</source>
            <translation>самое большое задание занимает %1</translation>
        </message>
        <message>
            <source>the largest job takes %1, two may be there</source>
            <translation>самое большое задание занимает %1, их может быть два</translation>
        </message>
        <message>
            <source>the last row does not close the spiral</source>
            <translation>последний ряд не замыкает спираль</translation>
        </message>
        <message>
            <source>the line has more than 1024 bytes</source>
            <translation>в строке больше 1024 байт</translation>
        </message>
        <message>
            <source>the machine came to rest (%1), somebody stopped it</source>
            <translation>станок остановился (%1), его кто-то остановил</translation>
        </message>
        <message>
            <source>the machine has moved since the program was read; start it again</source>
            <translation>станок сдвинулся с тех пор, как программа была прочитана; запустите её снова</translation>
        </message>
        <message>
            <source>the machine has no axis %1</source>
            <translation>у станка нет оси %1</translation>
        </message>
        <message>
            <source>the machine has no output for coolant</source>
            <translation>у станка нет выхода для охлаждения</translation>
        </message>
        <message>
            <source>the machine has no output for flood</source>
            <translation>у станка нет выхода для подачи СОЖ</translation>
        </message>
        <message>
            <source>the machine has no output for mist</source>
            <translation>у станка нет выхода для СОЖ распылением</translation>
        </message>
        <message>
            <source>the machine has not come to rest yet (%1)</source>
            <translation>станок ещё не остановился (%1)</translation>
        </message>
        <message>
            <source>the machine is %1; home it, jog %2 to the pin, and let it rest</source>
            <translation>станок: %1; найдите ноль, подведите %2 к штифту и дайте остановиться</translation>
        </message>
        <message>
            <source>the machine is busy; try again</source>
            <translation>станок занят; повторите</translation>
        </message>
        <message>
            <source>the machine is not at rest; stop first</source>
            <translation>станок не стоит; сначала остановите его</translation>
        </message>
        <message>
            <source>the machine is not homed; home first</source>
            <translation>ноль станка не найден; сначала найдите ноль</translation>
        </message>
        <message>
            <source>the machine was moved or its spindle switched meanwhile; nothing was begun, start it again</source>
            <translation>за это время станок сдвинули или переключили шпиндель; ничего не начато, пустите снова</translation>
        </message>
        <message>
            <source>the mesh has no volume (all of it is flat); there is nothing to carve</source>
            <translation>у сетки нет объёма (вся плоская); резать нечего</translation>
        </message>
        <message>
            <source>the number of an O word is whole</source>
            <translation>номер слова O — целое число</translation>
        </message>
        <message>
            <source>the port does not answer: switch the machine off by its own switch</source>
            <translation>порт не отвечает: выключите станок его собственным выключателем</translation>
        </message>
        <message>
            <source>the port has failed; reset the alarm, then home</source>
            <translation>порт дал сбой; сбросьте аварию, затем найдите нули</translation>
        </message>
        <message>
            <source>the printer driver may take the port</source>
            <translation>драйвер принтера может занять порт</translation>
        </message>
        <message>
            <source>the process that feeds it is gone: only Stop is left</source>
            <translation>процесс, который её подаёт, пропал: остаётся только «Стоп»</translation>
        </message>
        <message>
            <source>the profile is %1 bytes long; the most is %2</source>
            <translation>профиль занимает %1 байт; допустимо не больше %2</translation>
        </message>
        <message>
            <source>the program breaks off behind line %1: who read it is gone; start it again</source>
            <translation>программа обрывается за строкой %1: читавшего её процесса больше нет; запустите её снова</translation>
        </message>
        <message>
            <source>the program does not reach the core as it was read; start it again</source>
            <translation>программа доходит до ядра не такой, какой прочитана; запустите её снова</translation>
        </message>
        <message>
            <source>the program ends before line %1; begin at an earlier line</source>
            <translation>программа кончается до строки %1; начните с более ранней</translation>
        </message>
        <message>
            <source>the program has no end</source>
            <translation>у программы нет конца</translation>
        </message>
        <message>
            <source>the program has no subroutine %1</source>
            <translation>в программе нет подпрограммы %1</translation>
        </message>
        <message>
            <source>the program is empty</source>
            <translation>программа пуста</translation>
        </message>
        <message>
            <source>the program was given up</source>
            <translation>от программы отказались</translation>
        </message>
        <message>
            <source>the published job is damaged; publish it again</source>
            <translation>опубликованное задание повреждено; опубликуйте его снова</translation>
        </message>
        <message>
            <source>the pulses of a dry run</source>
            <translation>импульсы холостого прогона</translation>
        </message>
        <message>
            <source>the same job</source>
            <translation>то же задание</translation>
        </message>
        <message>
            <source>the speed must be above 0</source>
            <translation>скорость должна быть больше 0</translation>
        </message>
        <message>
            <source>the spindle is on; for a dry run switch it off</source>
            <translation>шпиндель включён; для холостого прогона выключите его</translation>
        </message>
        <message>
            <source>the stepdown must be more than 0 mm, and %1 at most, not %2</source>
            <translation>шаг вглубь должен быть больше 0 mm и не больше %1, а не %2</translation>
        </message>
        <message>
            <source>the stepover must be more than 0 mm, not %1</source>
            <translation>шаг слоёв должен быть больше 0 mm, а не %1</translation>
        </message>
        <message>
            <source>the stream ends within a line: it may have been torn off, and is not run</source>
            <translation>поток кончается внутри строки: он мог оборваться, и она не исполняется</translation>
        </message>
        <message>
            <source>the subroutine that M98 calls has no M99</source>
            <translation>у подпрограммы, вызванной через M98, нет M99</translation>
        </message>
        <message>
            <source>the switch of the axis is open; there is nothing to back off from</source>
            <translation>выключатель оси разомкнут; отводить не от чего</translation>
        </message>
        <message>
            <source>the table has no layers</source>
            <translation>в таблице нет слоёв</translation>
        </message>
        <message>
            <source>the table has roughing passes of its own: it gets no others</source>
            <translation>в таблице есть свои черновые проходы: другие не добавляются</translation>
        </message>
        <message>
            <source>the table's %1 points a circle are evened to %2</source>
            <translation>точки таблицы, %1 на круг, выровнены до %2</translation>
        </message>
        <message>
            <source>the table's axis would be outside a blank of radius %1 mm; set blank.radius_mm, or a lesser offset</source>
            <translation>ось стола оказалась бы вне заготовки радиусом %1 mm; задайте blank.radius_mm или меньшее смещение</translation>
        </message>
        <message>
            <source>the table's last layer is not whole, or there is none</source>
            <translation>последний слой таблицы не полон, или слоёв нет</translation>
        </message>
        <message>
            <source>the tip of %1 would stand %2 mm further out than counted; is the pin's diameter %3 mm, and does the tip touch it at %4 mm?</source>
            <translation>острие %1 стояло бы на %2 mm дальше, чем считается; диаметр штифта %3 mm, и острие касается его на %4 mm?</translation>
        </message>
        <message>
            <source>the tips of r1 and r2 are %1 mm apart, closer than head_clearance_mm = %2 mm</source>
            <translation>между остриями r1 и r2 %1 mm, меньше head_clearance_mm = %2 mm</translation>
        </message>
        <message>
            <source>the travel from %1 to %2 mm is empty or reversed; give the lowest position first</source>
            <translation>ход от %1 до %2 mm пуст или перевёрнут; сначала укажите нижнее положение</translation>
        </message>
        <message>
            <source>the value is infinite, or none at all</source>
            <translation>значение бесконечно или не существует</translation>
        </message>
        <message>
            <source>the whole job</source>
            <translation>всё задание</translation>
        </message>
        <message>
            <source>the work offsets have been changed since it was read; decode it again</source>
            <translation>рабочие смещения изменены после чтения; разберите её снова</translation>
        </message>
        <message>
            <source>the zip archive is cut off or damaged</source>
            <translation>архив zip обрезан или повреждён</translation>
        </message>
        <message>
            <source>then about Y</source>
            <translation>затем вокруг Y</translation>
        </message>
        <message>
            <source>then about Z</source>
            <translation>затем вокруг Z</translation>
        </message>
        <message>
            <source>there</source>
            <translation>есть</translation>
        </message>
        <message>
            <source>there is no &lt;svg&gt; element</source>
            <translation>нет элемента &lt;svg&gt;</translation>
        </message>
        <message>
            <source>there is no alarm</source>
            <translation>аварии нет</translation>
        </message>
        <message>
            <source>these are no two numbers; enter them as 0.0 ... 60.0</source>
            <translation>это не два числа; введите их так: 0.0 ... 60.0</translation>
        </message>
        <message>
            <source>these work offsets cannot be kept</source>
            <translation>эти рабочие смещения нельзя сохранить</translation>
        </message>
        <message>
            <source>this is no DXF file: it does not begin with a section</source>
            <translation>это не файл DXF: он не начинается с раздела</translation>
        </message>
        <message>
            <source>this is no number; enter %1 &lt;= value &lt;= %2</source>
            <translation>это не число; введите от %1 до %2</translation>
        </message>
        <message>
            <source>this is no whole number; enter %1 &lt;= value &lt;= %2</source>
            <translation>это не целое число; введите от %1 до %2</translation>
        </message>
        <message>
            <source>this is no word that can follow O</source>
            <translation>такое слово за O стоять не может</translation>
        </message>
        <message>
            <source>this is not TOML: %1; correct the line</source>
            <translation>это не TOML: %1; исправьте строку</translation>
        </message>
        <message>
            <source>this is not well-formed XML</source>
            <translation>XML составлен неверно</translation>
        </message>
        <message>
            <source>this kernel lets nobody at addresses</source>
            <translation>это ядро никого не допускает к адресам портов</translation>
        </message>
        <message>
            <source>this kernel lets nobody at addresses: it is locked down (Secure Boot), or this is a container</source>
            <translation>это ядро никого не допускает к адресам портов: оно заблокировано (Secure Boot) или это контейнер</translation>
        </message>
        <message>
            <source>this kernel lets nobody at addresses: it is locked down (Secure Boot), or this is a container; --port ppdev:/dev/parport0 needs no such right</source>
            <translation>это ядро никого не допускает к адресам портов: оно заблокировано (Secure Boot) или это контейнер; для --port ppdev:/dev/parport0 такое право не нужно</translation>
        </message>
        <message>
            <source>this kernel lets nobody at addresses; --port ppdev:/dev/parport0 needs no such right</source>
            <translation>это ядро никого не допускает к адресам портов; для --port ppdev:/dev/parport0 такое право не нужно</translation>
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
            <source>time from point to point</source>
            <translation>время между точками</translation>
        </message>
        <message>
            <source>time not known</source>
            <translation>время неизвестно</translation>
        </message>
        <message>
            <source>to look at</source>
            <translation>взглянуть</translation>
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
            <source>tool change (M6)</source>
            <translation>смена инструмента (M6)</translation>
        </message>
        <message>
            <source>true or false</source>
            <translation>true или false</translation>
        </message>
        <message>
            <source>turn of the table in a layer [pulses]</source>
            <translation>поворот стола в слое [импульсы]</translation>
        </message>
        <message>
            <source>turn the axis in a block before the cycle</source>
            <translation>поверните ось в кадре перед циклом</translation>
        </message>
        <message>
            <source>turned by %1°</source>
            <translation>повёрнут на %1°</translation>
        </message>
        <message>
            <source>two codes of the block use P</source>
            <translation>P нужно двум кодам кадра</translation>
        </message>
        <message>
            <source>two programs on one port move motors by accident</source>
            <translation>две программы на одном порту двигают моторы случайно</translation>
        </message>
        <message>
            <source>under G90.1 an arc has both %1 and %2</source>
            <translation>при G90.1 у дуги есть и %1, и %2</translation>
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
            <source>undercut about %1 %</source>
            <translation>поднутрение около %1 %</translation>
        </message>
        <message>
            <source>unknown</source>
            <translation>неизвестно</translation>
        </message>
        <message>
            <source>unknown key; did you mean %1?</source>
            <translation>неизвестный ключ; имелся в виду %1?</translation>
        </message>
        <message>
            <source>unknown key; see profile show for all keys</source>
            <translation>неизвестный ключ; все ключи показывает profile show</translation>
        </message>
        <message>
            <source>unlimited</source>
            <translation>без ограничения</translation>
        </message>
        <message>
            <source>use --port ppdev:/dev/parport0</source>
            <translation>используйте --port ppdev:/dev/parport0</translation>
        </message>
        <message>
            <source>use G17, or take the rotation away with G10 L2 R0</source>
            <translation>используйте G17 или снимите поворот через G10 L2 R0</translation>
        </message>
        <message>
            <source>use G53 in a block with G0 or G1</source>
            <translation>используйте G53 в кадре с G0 или G1</translation>
        </message>
        <message>
            <source>use G53 under G90</source>
            <translation>используйте G53 при G90</translation>
        </message>
        <message>
            <source>use G94 for cycles</source>
            <translation>для циклов используйте G94</translation>
        </message>
        <message>
            <source>use M3: the spindle is only switched</source>
            <translation>используйте M3: шпиндель только включается и выключается</translation>
        </message>
        <message>
            <source>use an O word as docs/gcode.md has them</source>
            <translation>используйте слова O как в docs/gcode.md</translation>
        </message>
        <message>
            <source>use fewer levels: 64 of brackets, 100 of O words, 100 of calls</source>
            <translation>уменьшите число уровней: скобок до 64, слов O до 100, вызовов до 100</translation>
        </message>
        <message>
            <source>use fewer names</source>
            <translation>используйте меньше имён</translation>
        </message>
        <message>
            <source>use one of the G codes of docs/gcode.md</source>
            <translation>используйте G-код из docs/gcode.md</translation>
        </message>
        <message>
            <source>use one of the M codes of docs/gcode.md</source>
            <translation>используйте M-код из docs/gcode.md</translation>
        </message>
        <message>
            <source>use the GNU C library's allocator</source>
            <translation>используйте распределитель памяти библиотеки GNU C</translation>
        </message>
        <message>
            <source>use the letters that [gcode] in the profile gives to the axes</source>
            <translation>используйте буквы, данные осям в [gcode] профиля</translation>
        </message>
        <message>
            <source>use the operators and functions of docs/gcode.md</source>
            <translation>используйте операторы и функции из docs/gcode.md</translation>
        </message>
        <message>
            <source>use the parameters #1 to #5601</source>
            <translation>используйте параметры от #1 до #5601</translation>
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
            <source>waited for its lines: %1</source>
            <translation>ждала своих строк: %1</translation>
        </message>
        <message>
            <source>waiting</source>
            <translation>ждёт</translation>
        </message>
        <message>
            <source>waits for more of it</source>
            <translation>ждёт продолжения</translation>
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
            <source>what bounds the speed</source>
            <translation>что ограничивает скорость</translation>
        </message>
        <message>
            <source>what lies beyond the edge of &lt;%1&gt; is carved, too.</source>
            <translation>то, что выходит за край &lt;%1&gt;, тоже вырезается.</translation>
        </message>
        <message>
            <source>where %1 stands is needed</source>
            <translation>нужно положение %1</translation>
        </message>
        <message>
            <source>where it was recorded</source>
            <translation>конца записи</translation>
        </message>
        <message>
            <source>whole</source>
            <translation>цела</translation>
        </message>
        <message>
            <source>without area: %1</source>
            <translation>без площади: %1</translation>
        </message>
        <message>
            <source>write #number=value or #&lt;name&gt;=value</source>
            <translation>пишите #номер=значение или #&lt;имя&gt;=значение</translation>
        </message>
        <message>
            <source>write a number behind the letter</source>
            <translation>напишите число после буквы</translation>
        </message>
        <message>
            <source>write a whole number</source>
            <translation>напишите целое число</translation>
        </message>
        <message>
            <source>write it with fewer digits</source>
            <translation>напишите с меньшим числом цифр</translation>
        </message>
        <message>
            <source>write the subroutine into the same file</source>
            <translation>поместите подпрограмму в тот же файл</translation>
        </message>
        <message>
            <source>yes</source>
            <translation>да</translation>
        </message>
        <message>
            <source>zigzag</source>
            <translation>зигзаг</translation>
        </message>
        <message>
            <source>× NO CORE</source>
            <translation>× НЕТ ЯДРА</translation>
        </message>
        <message>
            <source>Ψ / °, Y upwards / mm</source>
            <translation>Ψ / °, вверх Y / mm</translation>
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
            <source>Ψ index: not known</source>
            <translation>метка Ψ: неизвестно</translation>
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
            <source>Ψ turns to %1°, all turns.</source>
            <translation>Ψ поворачивается на %1°, все обороты.</translation>
        </message>
        <message>
            <source>Ψ turns.</source>
            <translation>Ψ поворачивается.</translation>
        </message>
        <message>
            <source>← →  Ψ
↑ ↓  Y
PgUp PgDn  R1 out, in
Ctrl+PgUp PgDn  R2 out, in
Shift with these  one step</source>
            <translation>← →  Ψ
↑ ↓  Y
PgUp PgDn  R1 наружу, внутрь
Ctrl+PgUp PgDn  R2 наружу, внутрь
Shift вместе с ними  один шаг</translation>
        </message>
        <message>
            <source>← → Ψ   ↑ ↓ Y   PgUp PgDn R1
Ctrl+PgUp PgDn R2   Shift one step</source>
            <translation>← → Ψ   ↑ ↓ Y   PgUp PgDn R1
Ctrl+PgUp PgDn R2   Shift один шаг</translation>
        </message>
        <message>
            <source>≥ %1 mm</source>
            <translation>≥ %1 mm</translation>
        </message>
        <message>
            <source>⌀, round</source>
            <translation>⌀, обвод</translation>
        </message>
        <message>
            <source>○ index</source>
            <translation>○ метка</translation>
        </message>
        <message>
            <source>○ limit</source>
            <translation>○ КВ</translation>
        </message>
        <message>
            <source>● index</source>
            <translation>● метка</translation>
        </message>
        <message>
            <source>✓ CORE ALIVE</source>
            <translation>✓ ЯДРО РАБОТАЕТ</translation>
        </message>
    </context>
</TS>
