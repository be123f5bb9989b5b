import type { Signal } from "@preact/signals";
import { Download, FolderOpen, Save } from "lucide-preact";
import { authoringApi } from "../../api/authoring";
import { exchange } from "../../api/exchange";
import type { FileFound, Folder, Lesson } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { useAction } from "../../kit/requests/action";
import { FaultLine } from "../../kit/requests/FaultLine";
import { Loaded } from "../../kit/requests/Loaded";
import { valueIn } from "../../kit/requests/load_state";
import { setClassroom } from "../../shell/classroom";
import { fileName, saveFile } from "../../shell/files/save_file";
import { asTeacher } from "../../shell/teacher/teacher_session";
import { OpenLessonFile, openedText } from "../../work/OpenLessonFile";
import { useTeacherLoaded } from "../useTeacherLoaded";

interface LessonFileProps {
  /** The open lesson; null without one, so that there is nothing to save. */
  lesson: Lesson | null;
  /** Text about what was saved or opened last. */
  status: Signal<string>;
  onOpened(): Promise<void>;
}

/** Saves the file that prepares other PCs for the open lesson; opens a lesson file. */
export function LessonFile({ lesson, status, onOpened }: LessonFileProps) {
  const { file: labels } = texts.value.making;
  const folders = useTeacherLoaded("folders", async () => (await exchange.folders()).folders);
  // the buttons do not wait for the folders: what is below would move away from a click
  const found = valueIn(folders) ?? [];
  const { fault, act } = useAction(asTeacher);
  const openFound = (file: FileFound) =>
    act(async () => {
      const opened = await authoringApi.openFoundLesson(file.path);
      setClassroom(opened.classroom.id);
      status.value = openedText(opened);
      await onOpened();
    });
  return (
    <section class="panel card">
      <h2>{labels.title}</h2>
      <p class="teacher__hint">{labels.hint}</p>
      <div class="button-row">
        {lesson && <SaveButtons lesson={lesson} folders={found} status={status} act={act} />}
        <OpenLessonFile
          onOpened={async (opened) => {
            status.value = openedText(opened);
            await onOpened();
          }}
        />
        {found
          .flatMap((folder) => folder.files.filter((file) => file.lesson))
          .map((file) => (
            <Button
              key={file.path}
              icon={FolderOpen}
              testId="lesson-file-found"
              onPress={() => openFound(file)}
            >
              {labels.openFound({ name: file.name })}
            </Button>
          ))}
      </div>
      {folders.status === "failed" && <Loaded of={folders}>{() => null}</Loaded>}
      <p role="status" class="teacher__done" data-testid="lesson-file-done">
        {status.value}
      </p>
      <FaultLine fault={fault} />
    </section>
  );
}

interface SaveButtonsProps {
  lesson: Lesson;
  folders: readonly Folder[];
  status: { value: string };
  act(work: () => Promise<unknown>): Promise<boolean>;
}

function SaveButtons({ lesson, folders, status, act }: SaveButtonsProps) {
  const { file: labels } = texts.value.making;
  const save = async () => {
    const content = await authoringApi.lessonFile(lesson.id);
    const name = `${fileName(lesson.title, labels.name)}.pinel`;
    saveFile(name, content);
    status.value = labels.savedAs({ name });
  };
  const saveIn = async (folder: string) => {
    status.value = labels.savedAs({
      name: (await authoringApi.writeLessonFile(lesson.id, folder)).name,
    });
  };
  return (
    <>
      <Button icon={Download} testId="lesson-file-save" onPress={() => act(save)}>
        {labels.save}
      </Button>
      {folders
        .filter((folder) => folder.is_writable)
        .map(({ path, name }) => (
          <Button
            key={path}
            icon={Save}
            testId="lesson-file-save-in"
            onPress={() => act(() => saveIn(path))}
          >
            {labels.saveIn({ folder: name })}
          </Button>
        ))}
    </>
  );
}
