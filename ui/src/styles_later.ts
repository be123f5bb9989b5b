/*
 * The style sheets of all parts that are fetched when they are first shown, whichever it is, in one order: after those
 * of styles.ts, paper last. The start would have to read them for nothing.
 */
import "./world_editor/board.css";
import "./world_editor/world_editor.css";
import "./notes/notes.css";
import "./screens/group_head.css";
import "./screens/work.css";
import "./screens/keeping.css";
import "./screens/replay.css";
import "./versions/versions.css";
import "./versions/differences.css";
import "./teacher/teacher.css";
import "./teacher/lessons.css";
import "./exchange/exchange.css";
import "./review/parts.css";
import "./review/runs.css";
import "./review/line.css";
import "./review/lesson.css";
import "./review/compare.css";
import "./review/note.css";
import "./review/print.css";
