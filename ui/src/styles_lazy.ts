/*
 * Style sheets of all lazy parts. They load together, in this order, after those of styles.ts; the
 * sheet for print is last. They are separate because the start of the page does not need them.
 */
import "./frame/drive_dialog.css";
import "./world_editor/board/board.css";
import "./world_editor/world_editor.css";
import "./studio/mission/mission.css";
import "./activities/activities.css";
import "./album/album.css";
import "./studio/help/help.css";
import "./manuals/manuals.css";
import "./studio/tour/tour.css";
import "./camera/camera.css";
import "./camera/captured.css";
import "./studio/floor_pane/capture_camera.css";
import "./practice/practice.css";
import "./work/notes.css";
import "./work/group_head.css";
import "./work/work.css";
import "./work/programs.css";
import "./run/panels/time_strip.css";
import "./studio/floor_pane/last_run_timeline.css";
import "./truth/truth.css";
import "./replay/replay.css";
import "./run_image/run_image.css";
import "./versions/versions.css";
import "./versions/differences.css";
import "./teacher/teacher.css";
import "./teacher/lessons/lessons.css";
import "./teacher/making/making.css";
import "./teacher/camera/camera.css";
import "./teacher/robot/robot.css";
import "./teacher/robot/calibration/calibration.css";
import "./teacher/robot/overhead/overhead.css";
import "./teacher/plan/plan.css";
import "./teacher/cards/cards.css";
import "./teacher/exchange/exchange.css";
import "./teacher/review/parts.css";
import "./teacher/review/runs/runs.css";
import "./teacher/review/timeline/line.css";
import "./teacher/review/lesson/lesson.css";
import "./replay/compare/compare.css";
import "./presentation/presentation.css";
import "./teacher/review/notes/note.css";
import "./teacher/review/lesson/print.css";
