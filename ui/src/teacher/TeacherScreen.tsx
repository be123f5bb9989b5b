import {
  BookOpen,
  BookText,
  Bot,
  Camera,
  ClipboardList,
  Medal,
  Monitor,
  Usb,
  UsersRound,
} from "lucide-preact";
import { useLayoutEffect, useRef } from "preact/hooks";
import { texts } from "../i18n";
import { Loaded } from "../kit/requests/Loaded";
import { hashOf, type ParametersOf, TEACHER_PARTS } from "../shell/route";
import { CameraPart } from "./camera/CameraPart";
import { ClassesPart } from "./classes/ClassesPart";
import { ComputerPart } from "./computer/ComputerPart";
import { ExchangePanel } from "./exchange/ExchangePanel";
import { LessonsPart } from "./lessons/LessonsPart";
import { ActivitiesPart } from "./making/ActivitiesPart";
import { PlanPart } from "./plan/PlanPart";
import { RobotPart } from "./robot/RobotPart";
import { loadSchool } from "./school";
import { RequireTeacher } from "./sign_in/RequireTeacher";
import { useTeacherLoaded } from "./useTeacherLoaded";

const ICONS = {
  lessons: BookOpen,
  plan: ClipboardList,
  activities: Medal,
  classes: UsersRound,
  camera: Camera,
  robot: Bot,
  files: Usb,
  computer: Monitor,
} as const;

/**
 * The teacher's page: lessons, the plan of a lesson, own activities, classes and groups, camera,
 * real robots, files, this PC.
 */
export function TeacherScreen({ part }: ParametersOf<"teacher">) {
  const place = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    if (place.current) place.current.scrollTop = 0; // the title of a part is at its top
  }, [part]);
  return (
    <RequireTeacher>
      <main class="screen teacher">
        <PartLinks part={part} />
        <div ref={place} class="teacher__part column shrinks gap-4">
          <Part part={part} />
        </div>
      </main>
    </RequireTeacher>
  );
}

function PartLinks({ part }: ParametersOf<"teacher">) {
  const { parts } = texts.value.teacher;
  return (
    <nav class="teacher__nav column gap-1" aria-label={parts.label}>
      {TEACHER_PARTS.map((one) => {
        const Icon = ICONS[one];
        return (
          <a
            key={one}
            class="teacher__link row middle gap-3"
            href={hashOf({ screen: "teacher", part: one })}
            aria-current={one === part ? "page" : undefined}
            data-testid="teacher-part"
            data-part={one}
          >
            <Icon class="icon" aria-hidden="true" />
            {parts[one]}
          </a>
        );
      })}
      <a
        class="teacher__link teacher__manuals row middle gap-3"
        href={hashOf({ screen: "manuals", manual: null, section: null })}
        data-testid="teacher-manuals"
      >
        <BookText class="icon" aria-hidden="true" />
        {texts.value.titles.manuals}
      </a>
    </nav>
  );
}

function Part({ part }: ParametersOf<"teacher">) {
  if (part === "activities") return <ActivitiesPart />;
  if (part === "camera") return <CameraPart />;
  if (part === "robot") return <RobotPart />;
  if (part === "files") return <ExchangePanel />;
  if (part === "computer") return <ComputerPart />;
  return <SchoolPart part={part} />;
}

function SchoolPart({ part }: ParametersOf<"teacher">) {
  // loaded again for each part: pupils may have created groups in another window
  const school = useTeacherLoaded(part, loadSchool);
  return (
    <Loaded of={school}>
      {(found) => {
        if (part === "classes") return <ClassesPart school={found} reload={school.reload} />;
        if (part === "plan") return <PlanPart school={found} />;
        return <LessonsPart school={found} reload={school.reload} />;
      }}
    </Loaded>
  );
}
