import { BookOpen, Monitor, Usb, UsersRound } from "lucide-preact";
import { useEffect, useRef, useState } from "preact/hooks";
import { classesApi } from "../api/classes";
import { api } from "../api/client";
import type { Classroom, Group } from "../api/model";
import { hashOf, TEACHER_PARTS, type TeacherPart } from "../app/route";
import { group, program, report } from "../app/session";
import { door, giveUpWaiting, knowDoor } from "../app/teacher";
import { TEST } from "../app/testids";
import { ExchangePanel } from "../exchange/ExchangePanel";
import { ClassesPart } from "./ClassesPart";
import { ComputerPart } from "./ComputerPart";
import { DoorForm } from "./DoorForm";
import { LessonsPart } from "./LessonsPart";
import { Preparation } from "./Preparation";
import { words } from "./words";

/** Classes and groups of the file; `reload` after something was changed. */
export interface School {
  classes: Classroom[];
  groups: Group[];
  reload(): Promise<void>;
}

/** Behind the door: lessons, classes and groups, this PC. What was typed stays while the door is shut. */
export function TeacherScreen({ part }: { part: TeacherPart }) {
  const [preparing, setPreparing] = useState(false);
  const wasOpen = useRef(false);
  useEffect(() => {
    group.value = null;
    program.value = null;
    knowDoor().catch(report);
    return giveUpWaiting;
  }, []);
  // until it is done: the PIN is only the first step of it
  useEffect(() => {
    if (door.value?.has_pin === false) setPreparing(true);
  }, [door.value?.has_pin]);
  const now = door.value;
  if (!now) return <main class="screen" aria-busy="true" />;
  if (preparing || !now.has_pin) return <Preparation onDone={() => setPreparing(false)} />;
  wasOpen.current ||= now.is_open;
  return (
    <>
      {!now.is_open && <DoorForm again={wasOpen.current} />}
      {wasOpen.current && <Desk part={part} hidden={!now.is_open} />}
    </>
  );
}

const ICONS = { lessons: BookOpen, classes: UsersRound, files: Usb, computer: Monitor } as const;

function Desk({ part, hidden }: { part: TeacherPart; hidden: boolean }) {
  const { parts } = words.value;
  const [found, setFound] = useState<Omit<School, "reload"> | null>(null);
  const reload = async () => {
    const [classes, groups] = await Promise.all([classesApi.classrooms(), api.groups()]);
    setFound({ classes, groups });
  };
  // pupils may have made groups in another window meanwhile
  useEffect(() => {
    reload().catch(report);
  }, [part]);
  return (
    <main class="screen teacher" hidden={hidden}>
      <nav class="teacher__nav" aria-label={parts.label}>
        {TEACHER_PARTS.map((one) => {
          const Icon = ICONS[one];
          return (
            <a
              key={one}
              class="teacher__part"
              href={hashOf({ screen: "teacher", part: one })}
              aria-current={one === part ? "page" : undefined}
              data-testid={TEST.teacherPart}
              data-part={one}
            >
              <Icon class="icon" aria-hidden="true" />
              {parts[one]}
            </a>
          );
        })}
      </nav>
      <div class="teacher__desk">{found && <Part part={part} school={{ ...found, reload }} />}</div>
    </main>
  );
}

function Part({ part, school }: { part: TeacherPart; school: School }) {
  switch (part) {
    case "classes":
      return <ClassesPart school={school} />;
    case "files":
      return <ExchangePanel />;
    case "computer":
      return <ComputerPart />;
    default:
      return <LessonsPart school={school} />;
  }
}
