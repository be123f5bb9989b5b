import { LogOut } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { go } from "../app/route";
import { report } from "../app/session";
import { door, knowDoorAgain, leaveDoor } from "../app/teacher";
import { TEST } from "../app/testids";
import { texts } from "../i18n";

/** While the teacher's part is open, whatever the screen: a press shuts it. */
export function TeacherChip() {
  const { classes } = texts.value;
  useEffect(() => {
    knowDoorAgain().catch(report);
  }, []);
  if (!door.value?.is_open) return null;
  return (
    <button
      type="button"
      class="button header__teacher"
      aria-label={classes.leave}
      title={classes.open}
      data-testid={TEST.leaveDoor}
      onClick={() => {
        leaveDoor().then(() => go({ screen: "start" }), report);
      }}
    >
      <LogOut class="icon" aria-hidden="true" />
      <span class="header__word">{classes.leave}</span>
    </button>
  );
}
