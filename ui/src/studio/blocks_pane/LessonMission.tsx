import { useSignal } from "@preact/signals";
import { Target } from "lucide-preact";
import { texts } from "../../i18n";
import { UndoBanner } from "../../kit/UndoBanner";
import { beginActivity } from "../../shell/begin_activity";
import { lesson } from "../../shell/lesson";
import type { OpenProgram } from "../program/open_program";

/** Offers the activity of the lesson to a group that has another program open, and is not known to have passed it. */
export function LessonMission({ open }: { open: OpenProgram }) {
  const closedFor = useSignal<string | null>(null);
  const { value: now } = lesson;
  const mission = now?.mission;
  if (!mission || mission === open.setup.value.activity || mission === closedFor.value) return null;
  // what was passed is loaded with the mission of this program
  const isKnown = !open.setup.value.activity || open.mission.value !== null;
  if (!isKnown || open.passed.value.has(mission)) return null;
  const { activity } = texts.value;
  return (
    <UndoBanner
      text={activity.ofLesson({ title: now.activity || now.title })}
      action={activity.openOfLesson}
      Icon={Target}
      testId="lesson-mission"
      onBack={() => beginActivity(open.program.group_id, mission)}
      onClose={() => {
        closedFor.value = mission;
      }}
    />
  );
}
