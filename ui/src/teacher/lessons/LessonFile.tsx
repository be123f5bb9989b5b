import { useSignal } from "@preact/signals";
import { Download, FolderOpen, Save } from "lucide-preact";
import { exchange } from "../../api/exchange";
import { makingApi } from "../../api/making";
import type { FileFound, Folder, Lesson } from "../../api/model";
import { texts } from "../../i18n";
import { Button } from "../../kit/Button";
import { useAct } from "../../kit/requests/act";
import { FaultLine } from "../../kit/requests/FaultLine";
import { Loaded } from "../../kit/requests/Loaded";
import { fileName, saveFile } from "../../shell/save_file";
import { asTeacher } from "../../shell/teacher/teacher_session";
import { OpenLessonFile, openedWords } from "../../work/OpenLessonFile";
import { useTeacherLoaded } from "../useTeacherLoaded";

interface LessonFileProps {
  /** The open lesson; null without one, when there is nothing to save. */
  lesson: Lesson | null;
  onOpened(): Promise<void>;
}

/** Saves the file that prepares other PCs for the open lesson, and opens one. */
export function LessonFile({ lesson, onOpened }: LessonFileProps) {
  const { file: say } = texts.value.making;
  const folders = useTeacherLoaded("folders", async () => (await exchange.folders()).folders);
  const told = useSignal("");
  const { fault, act } = useAct(asTeacher);
  const openFound = (file: FileFound) =>
    act(async () => {
      told.value = openedWords(await makingApi.openFoundLesson(file.path));
      await onOpened();
    });
  return (
    <section class="panel card">
      <h2>{say.title}</h2>
      <p class="teacher__hint">{say.hint}</p>
      <Loaded of={folders}>
        {(found) => (
          <div class="button-row">
            {lesson && <SaveButtons lesson={lesson} folders={found} told={told} act={act} />}
            <OpenLessonFile
              onOpened={async (opened) => {
                told.value = openedWords(opened);
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
                  {say.openFound(file.name)}
                </Button>
              ))}
          </div>
        )}
      </Loaded>
      <p role="status" class="teacher__done" data-testid="lesson-file-done">
        {told.value}
      </p>
      <FaultLine fault={fault} />
    </section>
  );
}

interface SaveButtonsProps {
  lesson: Lesson;
  folders: readonly Folder[];
  told: { value: string };
  act(work: () => Promise<unknown>): Promise<boolean>;
}

function SaveButtons({ lesson, folders, told, act }: SaveButtonsProps) {
  const { file: say } = texts.value.making;
  const save = async () => {
    const content = await makingApi.lessonFile(lesson.id);
    const name = `${fileName(lesson.title, say.name)}.pinel`;
    saveFile(name, content);
    told.value = say.savedAs(name);
  };
  const saveIn = async (folder: string) => {
    told.value = say.savedAs((await makingApi.writeLessonFile(lesson.id, folder)).name);
  };
  return (
    <>
      <Button icon={Download} testId="lesson-file-save" onPress={() => act(save)}>
        {say.save}
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
            {say.saveIn(name)}
          </Button>
        ))}
    </>
  );
}
