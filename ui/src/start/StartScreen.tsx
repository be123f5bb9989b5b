import { useSignal } from "@preact/signals";
import { DoorClosed, DoorOpen, GraduationCap, Hand } from "lucide-preact";
import { useEffect } from "preact/hooks";
import { NO_CLASS } from "../api/classes";
import type { Classroom, Group, OpenedLesson } from "../api/model";
import { texts } from "../i18n";
import { Button } from "../kit/Button";
import { LinkButton } from "../kit/LinkButton";
import { Loaded } from "../kit/requests/Loaded";
import { useLoaded } from "../kit/requests/useLoaded";
import { ClassChips } from "../shell/ClassChips";
import { classroom, groupsIn, shownClass } from "../shell/classroom";
import { groupsAndClasses } from "../shell/first_answers";
import { hashOf } from "../shell/route";
import { group, program, report } from "../shell/session";
import { loadTeacherSession, teacherSession } from "../shell/teacher/teacher_session";
import { OpenLessonFile, openedText } from "../work/OpenLessonFile";
import { ImportProgram } from "../work/ProgramFile";
import { GroupCard } from "./GroupCard";
import { NewGroup } from "./NewGroup";
import { StartPicture } from "./StartPicture";

const SHOWN_AT_FIRST = 11;

interface LessonFileProps {
  /** Called after the lesson of a file was opened: its class and groups are on this PC. */
  onLesson(opened: OpenedLesson): Promise<void>;
}

interface Found {
  groups: Group[];
  classes: Classroom[];
}

/** Loads what the screen shows: links that appeared later would move the buttons below them. */
async function loadStart(): Promise<[Group[], Classroom[]]> {
  const [found] = await Promise.all([groupsAndClasses(), loadTeacherSession().catch(report)]);
  return found;
}

/** Shows the groups of a class with their pictures, and a field for a new group. */
export function StartScreen() {
  const found = useLoaded("start", loadStart);
  const opened = useSignal("");
  const onLesson = (lesson: OpenedLesson) => {
    opened.value = openedText(lesson);
    return found.reload();
  };
  useEffect(() => {
    group.value = null;
    program.value = null;
  }, []);
  return (
    <Loaded of={found} as="screen" actions={<TeacherLink />}>
      {([all, classes]) => {
        const groups = all.filter(({ of_teacher }) => !of_teacher);
        return groups.length + classes.length === 0 ? (
          <FirstGroup onLesson={onLesson} />
        ) : (
          <Groups groups={groups} classes={classes} opened={opened.value} onLesson={onLesson} />
        );
      }}
    </Loaded>
  );
}

interface GroupsProps extends Found, LessonFileProps {
  /** Text about the lesson file that was opened; "" without one. */
  opened: string;
}

function Groups({ groups, classes, opened, onLesson }: GroupsProps) {
  const { start, classes: labels } = texts.value;
  const shown = shownClass(classroom.value, classes, groups);
  const here = groupsIn(shown, groups);
  const withNone = shown === NO_CLASS || groups.some((one) => !one.classroom_id);
  const classroomId = shown === NO_CLASS ? null : shown;
  return (
    <main class="screen start">
      <div class="start__head row top apart gap-4">
        <h1 class="start__title">{here.length ? start.title : labels.emptyTitle}</h1>
        <div class="start__teacher row top">
          <div class="row wrap end">
            <PracticeLink />
            <ImportProgram />
            <LessonFileLink onLesson={onLesson} />
          </div>
          <TeacherLink />
        </div>
      </div>
      <p role="status" class={opened && "notice-box"} data-testid="lesson-opened">
        {opened}
      </p>
      {classes.length > 0 && <ClassChips classes={classes} withNone={withNone} shown={shown} />}
      {here.length ? (
        <Cards key={shown} groups={here} classroomId={classroomId} />
      ) : (
        <div class="start__empty">
          <div>
            <p class="start__hint">{labels.emptyHint}</p>
            <NewGroup key={shown} first classroomId={classroomId} others={[]} />
          </div>
          <StartPicture />
        </div>
      )}
    </main>
  );
}

interface CardsProps {
  groups: readonly Group[];
  classroomId: string | null;
}

function Cards({ groups, classroomId }: CardsProps) {
  const { start } = texts.value;
  const shown = useSignal(SHOWN_AT_FIRST);
  return (
    <>
      <ul class="start__groups" aria-label={start.groups}>
        <li>
          <NewGroup classroomId={classroomId} others={groups} />
        </li>
        {groups.slice(0, shown.value).map((one) => (
          <li key={one.id}>
            <GroupCard group={one} />
          </li>
        ))}
      </ul>
      {groups.length > shown.value && (
        <Button
          class="start__more"
          onPress={() => {
            shown.value += 24;
          }}
        >
          {start.more}
        </Button>
      )}
    </>
  );
}

function FirstGroup({ onLesson }: LessonFileProps) {
  const { start, classes } = texts.value;
  const isNew = teacherSession.value?.has_pin === false;
  return (
    <main class="screen start start--first">
      <StartPicture />
      <div>
        <h1 class="start__title">{start.firstTitle}</h1>
        <p class="start__hint">{start.firstHint}</p>
        <NewGroup first classroomId={null} others={[]} />
        {isNew ? (
          <a
            class="prepare row middle gap-4"
            href={hashOf({ screen: "teacher", part: "lessons" })}
            data-testid="prepare"
          >
            <GraduationCap class="icon prepare__icon" aria-hidden="true" />
            <span class="column">
              <strong>{classes.prepare}</strong>
              <span>{classes.prepareHint}</span>
            </span>
          </a>
        ) : (
          <TeacherLink />
        )}
        <div class="start__more-ways row wrap">
          <PracticeLink />
          <ImportProgram />
          <LessonFileLink onLesson={onLesson} />
        </div>
      </div>
    </main>
  );
}

/** Opens the lesson of a file. Hidden if a PIN exists: the teacher's part opens lessons then. */
function LessonFileLink({ onLesson }: LessonFileProps) {
  if (teacherSession.value?.has_pin !== false) return null;
  return <OpenLessonFile onOpened={onLesson} />;
}

/** Link to the practice of signs, which needs no program. */
function PracticeLink() {
  return (
    <LinkButton kind="plain" icon={Hand} href={hashOf({ screen: "practice" })} testId="practice">
      {texts.value.titles.practice}
    </LinkButton>
  );
}

function TeacherLink() {
  return (
    <LinkButton
      kind="plain"
      class="start__teacher-link rigid"
      icon={teacherSession.value?.is_open ? DoorOpen : DoorClosed}
      href={hashOf({ screen: "teacher", part: "lessons" })}
      testId="teacher-link"
    >
      {texts.value.classes.door}
    </LinkButton>
  );
}
