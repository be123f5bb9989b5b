import { LogOut } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { go } from "../../shell/route";
import { report } from "../../shell/session";
import {
  restoreTeacherSession,
  signOut,
  teacherSession,
} from "../../shell/teacher/teacher_session";

/** Shown on every screen while the teacher is signed in; a press signs the teacher out. */
export function TeacherChip() {
  const { classes } = texts.value;
  useEffect(() => {
    restoreTeacherSession().catch(report);
  }, []);
  if (!teacherSession.value?.is_open) return null;
  return (
    <Button
      class="header__teacher"
      icon={LogOut}
      label={classes.leave}
      tip={classes.open}
      testId="sign-out"
      onPress={() => signOut().then(() => go({ screen: "start" }))}
    >
      <span class="header__word">{classes.leave}</span>
    </Button>
  );
}
