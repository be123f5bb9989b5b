"""Views for people, with names and times in place of keys: Datasette and `sqlite-utils` show them first."""

from storage.run_validity import confirmation_status, counted

VIEWS = {
    "group_list": """
        SELECT classrooms.name AS class, groups.name, groups.color, groups.picture, groups.created_at, groups.used_at,
               (SELECT count(*) FROM programs WHERE group_id = groups.id AND deleted_at IS NULL) AS programs,
               (SELECT count(*) FROM runs WHERE group_id = groups.id) AS runs
        FROM groups LEFT JOIN classrooms ON classrooms.id = groups.classroom_id ORDER BY groups.used_at DESC""",
    "program_list": """
        SELECT classrooms.name AS class, groups.name AS "group", programs.name AS program, programs.created_at,
               programs.updated_at, programs.deleted_at,
               (SELECT count(*) FROM versions WHERE program_id = programs.id) AS versions
        FROM programs JOIN groups ON groups.id = programs.group_id
             LEFT JOIN classrooms ON classrooms.id = groups.classroom_id
        ORDER BY programs.id DESC""",
    "run_list": f"""
        SELECT runs.id, classrooms.name AS class, groups.name AS "group", lessons.title AS lesson,
               runs.program_name AS program, runs.world, runs.state, runs.reason, runs.activity,
               {counted()} AS passed, {confirmation_status()} AS unconfirmed,
               runs.started_at, runs.duration_s, runs.path_length_m, runs.closing_error_m,
               computers.name AS computer
        FROM runs LEFT JOIN groups ON groups.id = runs.group_id
             LEFT JOIN classrooms ON classrooms.id = groups.classroom_id
             LEFT JOIN lessons ON lessons.id = runs.lesson_id
             LEFT JOIN computers ON computers.id = runs.computer_id
        ORDER BY runs.id DESC""",
    "lesson_list": """
        SELECT classrooms.name AS class, lessons.title, lessons.activity, lessons.by_itself, lessons.opened_at,
               lessons.closed_at, computers.name AS computer, joined.title AS part_of,
               (SELECT count(*) FROM versions WHERE lesson_id = lessons.id) AS edits,
               (SELECT count(*) FROM runs WHERE lesson_id = lessons.id) AS runs
        FROM lessons LEFT JOIN classrooms ON classrooms.id = lessons.classroom_id
             LEFT JOIN computers ON computers.id = lessons.computer_id
             LEFT JOIN lessons AS joined ON joined.id = lessons.part_of
        ORDER BY lessons.opened_at DESC""",
    "version_list": """
        SELECT groups.name AS "group", programs.name AS program, versions.number, version_labels.text AS label,
               versions.created_at, versions.document IS NOT NULL AS can_run, lessons.title AS lesson
        FROM versions JOIN programs ON programs.id = versions.program_id
             JOIN groups ON groups.id = programs.group_id
             LEFT JOIN version_labels ON version_labels.id = versions.id
             LEFT JOIN lessons ON lessons.id = versions.lesson_id
        ORDER BY versions.id DESC""",
    "note_list": """
        SELECT groups.name AS "group", runs.program_name AS program, runs.started_at AS run, notes.text,
               notes.written_at, notes.seen_at
        FROM notes JOIN runs ON runs.id = notes.run_id LEFT JOIN groups ON groups.id = runs.group_id
        ORDER BY notes.written_at DESC""",
}
