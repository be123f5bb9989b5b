import { BookOpen } from "lucide-preact";
import { authoringApi } from "../api/authoring";
import type { OpenedLesson } from "../api/model";
import { texts } from "../i18n";
import { setClassroom } from "../shell/classroom";
import { FileButton } from "../shell/files/FileButton";
import { asTeacher } from "../shell/teacher/teacher_session";

interface OpenLessonFileProps {
  onOpened(opened: OpenedLesson): unknown;
}

/** Opens the lesson of a file on this PC; asks for the PIN if one exists. */
export function OpenLessonFile({ onOpened }: OpenLessonFileProps) {
  const { classes } = texts.value;
  const open = async (file: File) => {
    const opened = await asTeacher(() => authoringApi.openLessonFile(file));
    if (!opened) return;
    setClassroom(opened.classroom.id);
    await onOpened(opened);
  };
  return (
    <FileButton
      kind="plain"
      icon={BookOpen}
      accept=".pinel"
      testId="lesson-file-open"
      onFile={open}
    >
      {classes.openLessonFile}
    </FileButton>
  );
}

/** Text about the opened lesson file. */
export function openedText({ lesson, classroom, nothing_new }: OpenedLesson): string {
  const { classes } = texts.value;
  const opened = classes.lessonFileOpened({ title: lesson.title, classroom: classroom.name });
  return nothing_new ? `${opened} ${classes.lessonFileKnown}` : opened;
}
