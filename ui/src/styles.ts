/*
 * Every style sheet of the page, in the one order that the built page has too. Were each part to bring its own along, what is
 * fetched later would come after what was fetched before, and one screen would look different after another.
 * What a later sheet says about an element wins over an earlier one: what others build on stands first, paper last.
 */
import "./design/fonts.css";
import "./design/tokens.css";
import "./design/base.css";
import "./design/controls.css";
import "./screens/header.css";
import "./screens/pictures.css";
import "./screens/start.css";
import "./editor/editor.css";
import "./editor/reader.css";
import "./debug/debug.css";
import "./scene/scene.css";
import "./run/run.css";
import "./run/text/text.css";
import "./plots/plots.css";
import "./screens/studio.css";
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
